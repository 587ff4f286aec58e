#include "tests/layering/twin_rule.hpp"

#include <map>

#include "tests/layering/source_file.hpp"

namespace tedavis::tests::layering {
namespace {

// Sources without a test of their own name → the test that goes through all of them.
const std::map<std::string, std::string>& exemptions() {
    static const std::map<std::string, std::string> table = [] {
        std::map<std::string, std::string> pieces;
        for (const char* piece : {"attitude", "flight_path", "heading", "readouts", "speed_and_altitude"})
            pieces["render_core/draw/symbology/" + std::string(piece) + ".cpp"] =
                "tests/render_core/draw/symbology/test_symbology.cpp";
        return pieces;
    }();
    return table;
}

bool needs_twin(const std::string& path) {
    if (starts_with(path, "tests/") || starts_with(path, "toolchains/")) return false;
    const auto name = path.substr(path.rfind('/') + 1);
    return path.size() > 4 && path.substr(path.size() - 4) == ".cpp" && name != "main.cpp";
}

}  // namespace

std::string twin_of(const std::string& source_path) {
    const auto slash = source_path.rfind('/') + 1;
    return "tests/" + source_path.substr(0, slash) + "test_" + source_path.substr(slash);
}

std::vector<std::string> twin_findings(const std::set<std::string>& paths) {
    std::vector<std::string> findings;
    for (const std::string& path : paths) {
        const auto exemption = exemptions().find(path);
        const std::string& twin = exemption == exemptions().end() ? twin_of(path) : exemption->second;
        if (!needs_twin(path) || paths.count(twin) != 0) continue;
        findings.push_back(path + ":1: has no test " + twin);
    }
    return findings;
}

}  // namespace tedavis::tests::layering
