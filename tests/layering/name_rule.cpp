#include "tests/layering/name_rule.hpp"

#include <cctype>
#include <map>
#include <utility>

namespace tedavis::tests::layering {
namespace {

const std::map<std::string, std::string>& names() {
    static const std::map<std::string, std::string> table = {
        {"AirWay", "AirPath"},
        {"AllSpoken", "PhaseVotes"},
        {"CellMeeting", "CellHit"},
        {"ClutterControl", "DeclutterControl"},
        {"Crowding", "Declutter"},
        {"DrawnSight", "LineOfSight"},
        {"EffectCall", "EffectRequest"},
        {"EffectEntry", "EffectRow"},
        {"EpochMemory", "IntervalMemory"},
        {"Eye", "Camera"},
        {"EyeInput", "CameraInput"},
        {"EyePair", "StereoCameras"},
        {"FlownWay", "FlightTrail"},
        {"FrameApproach", "FramePreroll"},
        {"HeardAircraft", "ReceivedAircraft"},
        {"LabelEpoch", "LabelHistory"},
        {"LineWay", "LineDirection"},
        {"PassCrew", "ThreadTeam"},
        {"PlannedCamera", "PlannedPicture"},
        {"PlannedWay", "PlannedTrack"},
        {"QualityLadder", "QualityLevels"},
        {"RaisedWeights", "PriorityBoost"},
        {"RayMeeting", "RayHit"},
        {"Rung", "QualityLevel"},
        {"Spoken", "PhaseVote"},
        {"TransformWay", "TransformDirection"},
        {"TrueWay", "TrueSegment"},
        {"TubeWay", "TubePath"},
        {"WayMeasure", "PolylineMeasure"},
        {"WayPoint", "PolylineVertex"},
        {"any_true_way", "any_true_segment"},
        {"approach_epoch", "preroll_interval"},
        {"eye_pair", "stereo_cameras"},
        {"forget_turns", "cut_to_design"},
        {"gives_way", "may_declutter"},
        {"has_what_gives_way", "has_declutterable_data"},
        {"hear_traffic", "receive_traffic"},
        {"is_met", "is_hit"},
        {"judge_sight", "count_out_of_view"},
        {"kLadder", "kQualityLevels"},
        {"kLastRung", "kLastQualityLevel"},
        {"kRungs", "kQualityLevelCount"},
        {"kTurns", "kIterations"},
        {"keep_meeting", "keep_hit"},
        {"make_eye", "make_camera"},
        {"meet_cells", "intersect_cells"},
        {"meet_surface", "intersect_surface"},
        {"met_column", "hit_column"},
        {"met_row", "hit_row"},
        {"met_t", "hit_t"},
        {"planned_way", "planned_track"},
        {"set_meeting", "set_hit"},
        {"stand_at", "set_camera"},
        {"weigh_element", "apply_to_element"},
        {"weigh_elements", "apply_to_elements"},
        {"weigh_way", "weigh_vertices"},
    };
    return table;
}

bool begins_with_constant(const std::string& name, const std::string& beginning) {
    if (name.compare(0, beginning.size(), beginning) != 0) return false;
    return name.size() == beginning.size() || std::islower(static_cast<unsigned char>(name[beginning.size()])) == 0;
}

/// The name with every "colour" spelt "color", as part of a word too; empty where it has none.
std::string with_one_spelling(std::string name) {
    bool is_changed = false;
    for (const auto& [spelt, standard] :
         {std::pair("colour", "color"), std::pair("Colour", "Color"), std::pair("COLOUR", "COLOR")})
        for (std::size_t at = name.find(spelt); at != std::string::npos; at = name.find(spelt, at)) {
            name.replace(at, std::string_view(spelt).size(), standard);
            is_changed = true;
        }
    return is_changed ? name : std::string();
}

std::string standard_of(const std::string& name) {
    const auto found = names().find(name);
    if (found != names().end()) return found->second;
    if (std::string color = with_one_spelling(name); !color.empty()) return color;
    if (begins_with_constant(name, "kMost")) return "kMax" + name.substr(5);
    if (begins_with_constant(name, "kLeast")) return "kMin" + name.substr(6);
    return {};
}

}  // namespace

std::vector<std::string> name_findings(const SourceFile& file) {
    std::vector<std::string> findings;
    for (const Token& token : tokens_of(file))
        if (const std::string standard = standard_of(token.text); !standard.empty())
            findings.push_back(finding(file, token.line, "\"" + token.text + "\" is called " + standard + " here"));
    return findings;
}

}  // namespace tedavis::tests::layering
