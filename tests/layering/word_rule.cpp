#include "tests/layering/word_rule.hpp"

#include <algorithm>
#include <cctype>
#include <map>
#include <set>

namespace tedavis::tests::layering {
namespace {

struct WordRule {
    std::string message;
    std::vector<std::string> folders;
    std::set<std::string> words;                ///< wherever they stand as a name
    std::set<std::string> standard_words;       ///< only behind std::
    std::map<std::string, std::string> exempt;  ///< path or its beginning → why
};

const std::vector<WordRule>& rules() {
    static const std::vector<std::string> flight_code = {"render_core/", "bus/", "platform/", "target/"};
    static const std::vector<std::string> machine_free = {"render_core/", "bus/"};
    static const std::vector<WordRule> table = {
        {"flight code has no exceptions and no run-time types",
         flight_code,
         {"throw", "try", "catch", "dynamic_cast", "typeid"},
         {},
         {}},
        {"nothing allocates after start; use the arena or a fixed container",
         machine_free,
         {"new", "malloc", "calloc", "realloc", "aligned_alloc", "strdup", "make_unique", "make_shared"},
         {"vector", "string", "deque", "list", "map", "set", "unordered_map", "unordered_set", "function", "shared_ptr"},
         {{"render_core/base/config_reader.cpp", "reads configuration before start; the parser builds a tree"},
          {"bus/switches/switch_config.cpp", "reads configuration before start"},
          {"bus/switches/gpiod_v", "opens the lines once, at start"}}},
        {"time is an argument; only composition roots and platform/clock read a clock",
         machine_free,
         {"clock_gettime", "gettimeofday", "steady_clock", "system_clock", "high_resolution_clock", "nanosleep", "usleep"},
         {"chrono", "clock", "time"},
         {}},
        {"files are opened by the composition roots and read through ports",
         machine_free,
         {"fopen", "freopen", "tmpfile", "FILE", "getenv"},
         {"ifstream", "ofstream", "fstream", "filesystem"},
         {}},
    };
    return table;
}

bool begins_with_any(const std::string& path, const std::vector<std::string>& beginnings) {
    return std::any_of(beginnings.begin(), beginnings.end(), [&](const std::string& b) { return starts_with(path, b); });
}

bool is_exempt(const WordRule& rule, const std::string& path) {
    return std::any_of(rule.exempt.begin(), rule.exempt.end(), [&](const auto& entry) { return starts_with(path, entry.first); });
}

bool behind_std(const std::vector<Token>& tokens, std::size_t i) {
    return i >= 3 && tokens[i - 1].text == ":" && tokens[i - 2].text == ":" && tokens[i - 3].text == "std";
}

// `new (place) T` builds in memory that is there already; `new (std::nothrow) T` does not.
bool is_placement(const std::vector<Token>& tokens, std::size_t i) {
    return tokens[i].text == "new" && i + 2 < tokens.size() && tokens[i + 1].text == "(" && tokens[i + 2].text != "std";
}

bool in_preprocessor_include(const std::vector<Token>& tokens, std::size_t i) {
    return i >= 2 && tokens[i - 1].text == "<" && tokens[i - 2].text == "include";
}

void apply(const WordRule& rule, const SourceFile& file, const std::vector<Token>& tokens, std::vector<std::string>& findings) {
    if (!begins_with_any(file.path, rule.folders) || is_exempt(rule, file.path)) return;
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        const std::string& word = tokens[i].text;
        const bool named = rule.words.count(word) != 0 || (rule.standard_words.count(word) != 0 && behind_std(tokens, i));
        if (!named || is_placement(tokens, i) || in_preprocessor_include(tokens, i)) continue;
        findings.push_back(finding(file, tokens[i].line, "\"" + word + "\": " + rule.message));
    }
}

/// Not as a part of a longer word: manufacturers' codes and name templates hold such letters.
std::string::size_type find_word(const std::string& text, const std::string& word) {
    const auto is_letter = [&](std::size_t at) {
        return at < text.size() && std::isalnum(static_cast<unsigned char>(text[at])) != 0;
    };
    for (auto at = text.find(word); at != std::string::npos; at = text.find(word, at + 1))
        if (!is_letter(at - 1) && !is_letter(at + word.size())) return at;
    return std::string::npos;
}

void find_unfinished_work(const SourceFile& file, std::vector<std::string>& findings) {
    // Spelt in halves, so that this file passes its own rule.
    static const std::string marks[] = {std::string("TO") + "DO", std::string("FIX") + "ME", std::string("XX") + "X"};
    for (const std::string& mark : marks) {
        const auto at = find_word(file.text, mark);
        if (at == std::string::npos) continue;
        const auto line = 1 + std::count(file.text.begin(), file.text.begin() + static_cast<std::ptrdiff_t>(at), '\n');
        findings.push_back(finding(file, static_cast<int>(line), "\"" + mark + "\" marks unfinished work"));
    }
}

bool ends_with(const std::string& text, const std::string& end) {
    return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

}  // namespace

std::vector<std::string> word_findings(const SourceFile& file) {
    std::vector<std::string> findings;
    const auto tokens = tokens_of(file);
    for (const WordRule& rule : rules()) apply(rule, file, tokens, findings);
    find_unfinished_work(file, findings);
    if (ends_with(file.path, ".hpp") && file.text.find("#pragma once") == std::string::npos) {
        findings.push_back(finding(file, 1, "a header begins with #pragma once"));
    }
    return findings;
}

}  // namespace tedavis::tests::layering
