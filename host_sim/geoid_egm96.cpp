#include "host_sim/geoid_egm96.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>

#include "host_sim/input_file.hpp"
#include "host_sim/user_error.hpp"
#include "render_core/base/units.hpp"

namespace tedavis::host_sim {
namespace {

constexpr std::size_t kHeaderBytes = 40;

template <class T, class Bits>
T read_big_endian(const std::string& bytes, std::size_t offset) {
    Bits bits = 0;
    for (std::size_t i = 0; i < sizeof(Bits); ++i) bits = (bits << 8) | static_cast<unsigned char>(bytes[offset + i]);
    T value;
    std::memcpy(&value, &bits, sizeof value);
    return value;
}

}  // namespace

GeoidEgm96::GeoidEgm96(const std::string& path) {
    const std::string bytes = read_file(path);
    const auto refuse = [&](const std::string& what) {
        throw UserError(path + ": " + what + "; reinstall the package proj-data");
    };
    if (bytes.size() < kHeaderBytes) refuse("too short for a geoid grid");
    south_deg_ = read_big_endian<double, std::uint64_t>(bytes, 0);
    west_deg_ = read_big_endian<double, std::uint64_t>(bytes, 8);
    latitude_step_deg_ = read_big_endian<double, std::uint64_t>(bytes, 16);
    longitude_step_deg_ = read_big_endian<double, std::uint64_t>(bytes, 24);
    rows_ = read_big_endian<std::int32_t, std::uint32_t>(bytes, 32);
    columns_ = read_big_endian<std::int32_t, std::uint32_t>(bytes, 36);
    const bool sane = rows_ > 1 && columns_ > 1 && rows_ < 100'000 && columns_ < 100'000 && south_deg_ == -90.0 &&
                      std::abs((rows_ - 1) * latitude_step_deg_ - 180.0) < 1e-6 &&
                      std::abs(columns_ * longitude_step_deg_ - 360.0) < 1e-6;
    if (!sane) refuse("not a global geoid grid");
    const std::size_t count = static_cast<std::size_t>(rows_) * static_cast<std::size_t>(columns_);
    if (bytes.size() != kHeaderBytes + 4 * count)
        refuse("its size does not fit its header (" + std::to_string(bytes.size()) + " bytes)");
    heights_m_.resize(count);
    for (std::size_t i = 0; i < count; ++i) heights_m_[i] = read_big_endian<float, std::uint32_t>(bytes, kHeaderBytes + 4 * i);
}

GeoidEgm96 GeoidEgm96::installed() {
    for (const char* variable : {"PROJ_DATA", "PROJ_LIB"}) {
        const char* folder = std::getenv(variable);
        if (folder == nullptr) continue;
        const std::string path = std::string(folder) + "/egm96_15.gtx";
        if (std::filesystem::is_regular_file(path)) return GeoidEgm96(path);
    }
    for (const char* folder : {"/usr/share/proj", "/usr/local/share/proj"}) {
        const std::string path = std::string(folder) + "/egm96_15.gtx";
        if (std::filesystem::is_regular_file(path)) return GeoidEgm96(path);
    }
    throw UserError("egm96_15.gtx: the EGM96 geoid grid is not installed; install the Debian package proj-data");
}

double GeoidEgm96::node(int row, int column) const {
    const int wrapped = ((column % columns_) + columns_) % columns_;
    return static_cast<double>(
        heights_m_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(wrapped)]);
}

earth::GeoidUndulation GeoidEgm96::undulation(double latitude_rad, double longitude_rad) const {
    const double y =
        std::clamp((base::degrees(latitude_rad) - south_deg_) / latitude_step_deg_, 0.0, static_cast<double>(rows_ - 1));
    const double x = (base::degrees(earth::wrap_longitude(longitude_rad)) - west_deg_) / longitude_step_deg_;
    const int row = std::min(static_cast<int>(y), rows_ - 2);
    const int column = static_cast<int>(std::floor(x));
    const double v = y - row, u = x - column;
    const double south = node(row, column) * (1 - u) + node(row, column + 1) * u;
    const double north = node(row + 1, column) * (1 - u) + node(row + 1, column + 1) * u;
    return {south * (1 - v) + north * v};
}

}  // namespace tedavis::host_sim
