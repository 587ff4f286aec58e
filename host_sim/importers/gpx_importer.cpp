#include "host_sim/importers/gpx_importer.hpp"

#include <cpl_error.h>
#include <cpl_minixml.h>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <optional>

#include "host_sim/calendar_time.hpp"
#include "host_sim/user_error.hpp"
#include "render_core/base/units.hpp"

namespace tedavis::host_sim {
namespace {

struct XmlDestroyer {
    void operator()(CPLXMLNode* node) const { CPLDestroyXMLNode(node); }
};
using XmlTree = std::unique_ptr<CPLXMLNode, XmlDestroyer>;

XmlTree parse_xml(const std::string& text, const std::string& name) {
    CPLPushErrorHandler(CPLQuietErrorHandler);
    XmlTree tree(CPLParseXMLString(text.c_str()));
    const std::string fault = CPLGetLastErrorMsg();
    CPLErrorReset();
    CPLPopErrorHandler();
    if (tree == nullptr) throw UserError(name + ": not well-formed XML (" + fault + "); export the track again");
    CPLStripXMLNamespace(tree.get(), nullptr, TRUE);
    return tree;
}

std::optional<double> number(const CPLXMLNode* node, const char* key) {
    const char* text = CPLGetXMLValue(node, key, nullptr);
    if (text == nullptr || *text == '\0') return std::nullopt;
    char* end = nullptr;
    const double value = std::strtod(text, &end);
    while (*end == ' ' || *end == '\n' || *end == '\r' || *end == '\t') ++end;
    return *end == '\0' && std::isfinite(value) ? std::optional<double>(value) : std::nullopt;
}

template <class Visitor>
void for_each_child(const CPLXMLNode* parent, const char* name, Visitor visit) {
    for (const CPLXMLNode* child = parent->psChild; child != nullptr; child = child->psNext) {
        if (child->eType == CXT_Element && std::strcmp(child->pszValue, name) == 0) visit(child);
    }
}

struct PointCounts {
    std::size_t untimed = 0, malformed = 0;
};

void append_point(const CPLXMLNode* point, RecordedFlight& flight, PointCounts& counts) {
    const auto latitude = number(point, "lat"), longitude = number(point, "lon");
    if (!latitude || !longitude || std::abs(*latitude) > 90 || std::abs(*longitude) > 180) {
        ++counts.malformed;
        return;
    }
    const auto time = parse_iso8601(CPLGetXMLValue(point, "time", ""));
    if (!time) {
        ++counts.untimed;
        return;
    }
    RecordedFix fix;
    fix.time = *time;
    fix.latitude_rad = base::radians(*latitude);
    fix.longitude_rad = base::radians(*longitude);
    fix.gnss_height_m = number(point, "ele");
    fix.geoid_separation_m = number(point, "geoidheight");
    fix.ground_speed_mps = number(point, "speed");
    if (const auto course = number(point, "course")) fix.true_track_rad = base::radians(*course);
    flight.fixes.push_back(fix);
}

}  // namespace

ImportedFile import_gpx(std::string_view text, const std::string& name) {
    const XmlTree tree = parse_xml(std::string(text), name);
    const CPLXMLNode* gpx = CPLGetXMLNode(tree.get(), "=gpx");
    if (gpx == nullptr) throw UserError(name + ": XML, but its root is not <gpx>; give a GPX track");
    ImportedFile file;
    file.format = "GPX";
    PointCounts counts;
    std::size_t number_of_track = 0;
    for_each_child(gpx, "trk", [&](const CPLXMLNode* track) {
        RecordedFlight flight;
        flight.aircraft = std::to_string(++number_of_track);
        flight.callsign = CPLGetXMLValue(track, "name", "");
        flight.gnss_datum = HeightDatum::msl_egm96;
        for_each_child(track, "trkseg", [&](const CPLXMLNode* segment) {
            for_each_child(segment, "trkpt", [&](const CPLXMLNode* point) { append_point(point, flight, counts); });
        });
        if (!flight.fixes.empty()) file.flights.push_back(std::move(flight));
    });
    if (file.flights.empty())
        throw UserError(name +
                        ": no track point with a position and a time; give a recorded track, not a route or waypoints alone");
    if (counts.untimed > 0) file.notes.push_back(std::to_string(counts.untimed) + " track points have no time and were skipped");
    if (counts.malformed > 0)
        file.notes.push_back(std::to_string(counts.malformed) + " track points have no position and were skipped");
    return file;
}

}  // namespace tedavis::host_sim
