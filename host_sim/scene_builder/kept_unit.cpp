#include "host_sim/scene_builder/kept_unit.hpp"

#include <string_view>

#include "host_sim/scene_builder/fixed_unit.hpp"
#include "render_core/base/units.hpp"

namespace tedavis::host_sim {
namespace {

constexpr double kFreezing_K = 273.15;

struct UnitSpelling {
    std::string_view stated, unit;
    double factor, offset;
};
/// As the CF conventions, GRIB and tables write them.
constexpr UnitSpelling kSpellings[] = {{"m s**-1", "m/s", 1, 0},
                                       {"m s-1", "m/s", 1, 0},
                                       {"m s^-1", "m/s", 1, 0},
                                       {"m.s-1", "m/s", 1, 0},
                                       {"metres", "m", 1, 0},
                                       {"meters", "m", 1, 0},
                                       {"metre", "m", 1, 0},
                                       {"meter", "m", 1, 0},
                                       {"m**2 s**-2", "m2/s2", 1, 0},
                                       {"m2 s-2", "m2/s2", 1, 0},
                                       {"m^2/s^2", "m2/s2", 1, 0},
                                       {"kg kg**-1", "kg/kg", 1, 0},
                                       {"kg kg-1", "kg/kg", 1, 0},
                                       {"C", "K", 1, kFreezing_K},
                                       {"degC", "K", 1, kFreezing_K},
                                       {"\xC2\xB0"
                                        "C",
                                        "K", 1, kFreezing_K},
                                       {"hPa", "Pa", 100, 0},
                                       {"mbar", "Pa", 100, 0},
                                       {"millibars", "Pa", 100, 0},
                                       {"degrees", "rad", base::kRadiansPerDegree, 0},
                                       {"degree", "rad", base::kRadiansPerDegree, 0},
                                       {"knots", "m/s", base::kMpsPerKnot, 0},
                                       {"1", "", 1, 0}};

struct SuffixUnit {
    std::string_view end, unit;
};
constexpr SuffixUnit kSuffixes[] = {{"_mps", "m/s"}, {"_ft", "ft"},   {"_kt", "kt"},   {"_km", "km"},
                                    {"_nm", "NM"},   {"_deg", "deg"}, {"_rad", "rad"}, {"_hpa", "hPa"},
                                    {"_dbz", "dBZ"}, {"_c", "C"},     {"_k", "K"},     {"_m", "m"}};

}  // namespace

KeptUnit kept_unit(const std::string& stated) {
    constexpr std::size_t kLongest = 11;  // bytes of a unit in a database
    for (const UnitSpelling& known : kSpellings)
        if (known.stated == stated) return {std::string(known.unit), known.factor, known.offset};
    for (const char* const unit : {"m", "m/s", "rad"})
        if (const auto factor = factor_between(stated, unit)) return {unit, *factor, 0};
    return {stated.size() <= kLongest ? stated : "", 1, 0};
}

UnitSuffix unit_suffix(const std::string& column) {
    for (const SuffixUnit& known : kSuffixes) {
        const std::size_t length = column.size() - known.end.size();
        if (column.size() > known.end.size() && column.compare(length, known.end.size(), known.end) == 0)
            return {column.substr(0, length), std::string(known.unit)};
    }
    return {column, ""};
}

}  // namespace tedavis::host_sim
