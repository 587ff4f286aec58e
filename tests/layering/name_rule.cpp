#include "tests/layering/name_rule.hpp"

#include <cctype>
#include <map>

namespace tedavis::tests::layering {
namespace {

const std::map<std::string, std::string>& names() {
    static const std::map<std::string, std::string> table = {
        {"AllSpoken", "PhaseVotes"},
        {"CellMeeting", "CellHit"},
        {"Crowding", "Declutter"},
        {"DrawnSight", "LineOfSight"},
        {"EffectCall", "EffectRequest"},
        {"EffectEntry", "EffectRow"},
        {"EpochMemory", "IntervalMemory"},
        {"FlownWay", "FlightTrail"},
        {"FrameApproach", "FramePreroll"},
        {"LabelEpoch", "LabelHistory"},
        {"PassCrew", "ThreadTeam"},
        {"RaisedWeights", "PriorityBoost"},
        {"RayMeeting", "RayHit"},
        {"Spoken", "PhaseVote"},
        {"TubeWay", "TubePath"},
        {"WayPoint", "PolylineVertex"},
        {"approach_epoch", "preroll_interval"},
        {"forget_turns", "cut_to_design"},
        {"hear_traffic", "receive_traffic"},
        {"judge_sight", "count_out_of_view"},
        {"weigh_way", "weigh_vertices"},
    };
    return table;
}

bool begins_with_constant(const std::string& name, const std::string& beginning) {
    if (name.compare(0, beginning.size(), beginning) != 0) return false;
    return name.size() == beginning.size() || std::islower(static_cast<unsigned char>(name[beginning.size()])) == 0;
}

std::string standard_of(const std::string& name) {
    const auto found = names().find(name);
    if (found != names().end()) return found->second;
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
