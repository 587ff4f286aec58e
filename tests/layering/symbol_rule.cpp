#include "tests/layering/symbol_rule.hpp"

#include <cctype>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "tests/layering/source_file.hpp"

namespace tedavis::tests::layering {
namespace {

// Objects that run before start only → why they may use the heap.
const std::map<std::string, std::string>& start_up_objects() {
    static const std::map<std::string, std::string> table = {
        {"config_reader.cpp.o", "parses configuration files before start"},
        {"switch_config.cpp.o", "reads configuration before start"},
        {"gpiod_v1_lines.cpp.o", "opens the lines once, at start"},
        {"gpiod_v2_lines.cpp.o", "opens the lines once, at start"},
    };
    return table;
}

bool is_heap(const std::string& name) {
    static const std::set<std::string> names = {"malloc", "calloc", "realloc", "aligned_alloc", "posix_memalign", "strdup"};
    return names.count(name) != 0 || starts_with(name, "_Znw") || starts_with(name, "_Zna");
}

bool is_exception(const std::string& name) {
    return starts_with(name, "__cxa_throw") || starts_with(name, "__cxa_allocate_exception") || name == "__dynamic_cast" ||
           starts_with(name, "__cxa_begin_catch");
}

bool is_clock_or_file(const std::string& name) {
    static const std::set<std::string> names = {"clock_gettime", "gettimeofday", "time",    "clock",  "nanosleep",
                                                "usleep",        "fopen",        "fopen64", "getenv", "rand"};
    return names.count(name) != 0 || name.find("6chrono") != std::string::npos;
}

bool is_gl_entry_point(const std::string& name) {
    return (name.size() > 2 && starts_with(name, "gl") && std::isupper(static_cast<unsigned char>(name[2])) != 0) ||
           (name.size() > 3 && starts_with(name, "egl") && std::isupper(static_cast<unsigned char>(name[3])) != 0);
}

const char* objection(const UndefinedSymbol& symbol) {
    if (is_heap(symbol.name)) {
        return start_up_objects().count(symbol.member) != 0 ? nullptr : "nothing below the roots allocates";
    }
    if (is_exception(symbol.name)) return "flight code has no exceptions";
    if (is_clock_or_file(symbol.name)) return "time and files come through arguments and ports";
    if (is_gl_entry_point(symbol.name)) return "GL is reached through the call table only";
    return nullptr;
}

}  // namespace

std::vector<UndefinedSymbol> parse_nm(const std::string& output) {
    static const std::regex pattern(R"re(.*?([^:/]+):\s+[Uwv] (\S+))re");
    std::vector<UndefinedSymbol> symbols;
    std::istringstream lines(output);
    std::string line;
    while (std::getline(lines, line)) {
        std::smatch match;
        if (std::regex_match(line, match, pattern)) symbols.push_back({match[1], match[2]});
    }
    return symbols;
}

std::vector<std::string> symbol_findings(const std::vector<UndefinedSymbol>& symbols) {
    std::vector<std::string> findings;
    for (const UndefinedSymbol& symbol : symbols) {
        if (const char* why = objection(symbol)) findings.push_back(symbol.member + " asks for " + symbol.name + ": " + why);
    }
    return findings;
}

}  // namespace tedavis::tests::layering
