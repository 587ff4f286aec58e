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
        {"CallingDesign", "RequestingDesign"},
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
        {"design_calling_for", "design_requesting"},
        {"eye_pair", "stereo_cameras"},
        {"forget_turns", "cut_to_design"},
        {"gives_way", "may_declutter"},
        {"has_what_gives_way", "has_declutterable_data"},
        {"hear_traffic", "receive_traffic"},
        {"is_met", "is_hit"},
        {"judge_sight", "count_out_of_view"},
        {"kCallingDesigns", "kRequestingDesigns"},
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
        {"note_delay", "record_delay"},
        {"note_failure", "record_failure"},
        {"note_latency", "record_latency"},
        {"note_terrain_use", "record_terrain_use"},
        {"planned_way", "planned_track"},
        {"set_meeting", "set_hit"},
        {"stand_at", "set_camera"},
        {"weigh_element", "apply_to_element"},
        {"weigh_elements", "apply_to_elements"},
        {"weigh_way", "weigh_vertices"},
    };
    return table;
}

/// Phrases of this project's own, and what plain English says. The standard names what is meant, not the exact words.
const std::map<std::string, std::string>& phrases() {
    static const std::map<std::string, std::string> table = {
        {"flown way", "flight trail"},
        {"follow from nothing", "does not depend on earlier frames"},
        {"follows from nothing", "does not depend on earlier frames"},
        {"gave way", "was reduced, was replaced"},
        {"give way", "is reduced, is replaced"},
        {"given way", "was reduced, was replaced"},
        {"gives way", "is reduced, is replaced"},
        {"giving way", "being reduced, being replaced"},
        {"seen from elsewhere", "from another viewpoint"},
        {"takes its turn", "draws next, is shown"},
        {"turn of designs", "design transition"},
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

bool is_page(const std::string& path) { return path.size() > 3 && path.compare(path.size() - 3, 3, ".md") == 0; }

/// A text in lower case, with one space between its words, whatever lines and marks of comments lie between.
struct Prose {
    std::string text;
    std::vector<int> lines;  ///< of each character
};

Prose prose_of(const std::string& text) {
    Prose prose;
    int line = 1;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto c = static_cast<unsigned char>(text[i]);
        const bool is_gap = std::isspace(c) != 0 || c == '/' || c == '<' || c == '*';
        if (!is_gap || (!prose.text.empty() && prose.text.back() != ' ')) {
            prose.text += is_gap ? ' ' : static_cast<char>(std::tolower(c));
            prose.lines.push_back(line);
        }
        if (c == '\n') ++line;
    }
    return prose;
}

/// The places of a phrase, as whole words.
std::vector<std::size_t> places_of(const std::string& phrase, const std::string& text) {
    const auto is_letter = [&](std::size_t at) {
        return at < text.size() && std::isalpha(static_cast<unsigned char>(text[at])) != 0;
    };
    std::vector<std::size_t> places;
    for (auto at = text.find(phrase); at != std::string::npos; at = text.find(phrase, at + 1))
        if (!(at > 0 && is_letter(at - 1)) && !is_letter(at + phrase.size())) places.push_back(at);
    return places;
}

}  // namespace

std::vector<std::string> phrase_findings(const SourceFile& file) {
    const Prose prose = prose_of(is_page(file.path) ? file.text : comments_only(file.text));
    std::vector<std::string> findings;
    for (const auto& [phrase, standard] : phrases())
        for (const std::size_t place : places_of(phrase, prose.text))
            findings.push_back(finding(file, prose.lines[place], "\"" + phrase + "\" is this project's own; say: " + standard));
    return findings;
}

std::vector<std::string> name_findings(const SourceFile& file) {
    std::vector<std::string> findings;
    for (const Token& token : tokens_of(file))
        if (const std::string standard = standard_of(token.text); !standard.empty())
            findings.push_back(finding(file, token.line, "\"" + token.text + "\" is called " + standard + " here"));
    return findings;
}

}  // namespace tedavis::tests::layering
