#include "host_sim/terrain_builder/vertical_reference.hpp"

#include <cpl_conv.h>
#include <cpl_string.h>
#include <cpl_vsi.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <string_view>

namespace tedavis::host_sim {
namespace {

constexpr double kInternationalFoot_m = 0.3048, kUsSurveyFoot_m = 1200.0 / 3937.0;

std::string lower(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

bool holds(const std::string& text, const char* part) { return text.find(part) != std::string::npos; }

std::string text_or_empty(const char* text) { return text == nullptr ? std::string() : std::string(text); }

template <std::size_t N>
bool is_one_of(const std::string& word, const std::array<std::string_view, N>& words) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

/// CF conventions 1.8, standard name table: what a variable's heights are above.
VerticalReference cf_reference(GDALRasterBand& band) {
    constexpr std::array<std::string_view, 1> kEllipsoidal = {"height_above_reference_ellipsoid"};
    constexpr std::array<std::string_view, 5> kOfTheSea = {"altitude", "surface_altitude", "height_above_geopotential_datum",
                                                           "height_above_mean_sea_level", "bedrock_altitude"};
    VerticalReference reference;
    reference.name = text_or_empty(band.GetMetadataItem("standard_name"));
    if (is_one_of(reference.name, kEllipsoidal)) reference.datum = VerticalDatum::ellipsoid;
    if (is_one_of(reference.name, kOfTheSea)) reference.datum = VerticalDatum::egm96;
    reference.is_depth = lower(text_or_empty(band.GetMetadataItem("positive"))) == "down" || holds(reference.name, "depth");
    return reference;
}

/// USGS, "Standards for Digital Elevation Models", part 2: record A, bytes 889 and 890, a code of two digits.
VerticalReference usgs_reference(const char* file) {
    constexpr vsi_l_offset kCodeAt = 888;
    char code[2] = {};
    VSILFILE* const stream = VSIFOpenL(file, "rb");
    if (stream == nullptr) return {};
    const bool read = VSIFSeekL(stream, kCodeAt, SEEK_SET) == 0 && VSIFReadL(code, 1, 2, stream) == 2;
    VSIFCloseL(stream);
    VerticalReference reference;
    if (!read || (code[0] != ' ' && code[0] != '0')) return reference;
    if (code[1] == '1') reference.name = "local mean sea level";
    if (code[1] == '2') reference.name = "NGVD 29";
    if (code[1] == '3') reference.name = "NAVD 88";
    if (!reference.name.empty()) reference.datum = VerticalDatum::egm96;
    return reference;
}

/// ESRI's old projection files name the unit of heights in a line of its own, which GDAL leaves out.
VerticalReference esri_reference(const char* file) {
    VerticalReference reference;
    const CPLStringList lines(CSLLoad2(CPLResetExtension(file, "prj"), 1000, 1000, nullptr));
    for (int n = 0; n < lines.Count(); ++n) {
        const CPLStringList words(CSLTokenizeString(lines[n]));
        if (words.Count() == 2 && lower(words[0]) == "zunits") reference.unit = words[1];
    }
    return reference;
}

}  // namespace

VerticalReference vertical_reference(const OGRSpatialReference& crs) {
    VerticalReference reference;
    if (crs.IsCompound() == 0) {
        if (crs.GetAxesCount() == 3 && crs.IsGeocentric() == 0) {
            reference.datum = VerticalDatum::ellipsoid;
            reference.name = "ellipsoidal height of " + text_or_empty(crs.GetName());
        }
        return reference;
    }
    reference.name = text_or_empty(crs.GetAttrValue("COMPD_CS|VERT_CS"));
    const std::string names = lower(reference.name + " " + text_or_empty(crs.GetAttrValue("COMPD_CS|VERT_CS|VERT_DATUM")));
    reference.datum = holds(names, "ellipsoid") ? VerticalDatum::ellipsoid : VerticalDatum::egm96;
    OGRAxisOrientation direction = OAO_Other;
    if (crs.GetAxis("COMPD_CS|VERT_CS", 0, &direction) != nullptr) reference.is_depth = direction == OAO_Down;
    const char* unit = nullptr;
    (void)crs.GetTargetLinearUnits("COMPD_CS|VERT_CS", &unit);
    reference.unit = text_or_empty(unit);
    return reference;
}

VerticalReference vertical_reference_of_band(GDALDataset& dataset) {
    const std::string driver = dataset.GetDriverName();
    if (driver == "netCDF") return cf_reference(*dataset.GetRasterBand(1));
    if (driver == "AAIGrid") return esri_reference(dataset.GetDescription());
    if (driver == "USGSDEM") return usgs_reference(dataset.GetDescription());
    return {};
}

bool is_other_sea_level(const VerticalReference& reference) {
    constexpr std::array<const char*, 5> kNoOther = {"egm96", "egm 96", "mean sea level", "msl", "altitude"};
    const std::string name = lower(reference.name);
    return reference.datum == VerticalDatum::egm96 && !name.empty() && name != "unknown" && name != "unnamed" &&
           std::none_of(kNoOther.begin(), kNoOther.end(), [&](const char* part) { return holds(name, part); });
}

OGRSpatialReference horizontal_part(const OGRSpatialReference& crs) {
    OGRSpatialReference horizontal = crs;
    if (horizontal.IsCompound() != 0) horizontal.StripVertical();
    if (horizontal.GetAxesCount() == 3) horizontal.DemoteTo2D(nullptr);
    horizontal.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    return horizontal;
}

std::optional<double> metres_per_unit(const std::string& name) {
    const std::string unit = lower(name);
    for (const char* metre : {"", "m", "metre", "meter", "metres", "meters", "no"})  // "no": ESRI's for no statement
        if (unit == metre) return 1.0;
    for (const char* foot : {"ft", "foot", "feet", "international foot", "ift"})
        if (unit == foot) return kInternationalFoot_m;
    for (const char* foot : {"us survey foot", "us survey feet", "us-ft", "ftus", "foot_us", "ft_us", "sft"})
        if (unit == foot) return kUsSurveyFoot_m;
    if (unit == "cm" || unit == "centimetre" || unit == "centimeter") return 0.01;
    if (unit == "mm" || unit == "millimetre" || unit == "millimeter") return 0.001;
    if (unit == "km" || unit == "kilometre" || unit == "kilometer") return 1000.0;
    return std::nullopt;
}

}  // namespace tedavis::host_sim
