#include "tests/layering/length_rule.hpp"

#include <sstream>

namespace tedavis::tests::layering {
namespace {

constexpr std::size_t kIndent = 4;
constexpr const char* kTypes[] = {"namespace", "struct", "class", "enum", "union", "extern"};

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

bool ends_with(const std::string& text, char last) {
    const auto end = text.find_last_not_of(' ');
    return end != std::string::npos && text[end] == last;
}

/// A line that opens a block of statements.
bool is_head(const std::string& line) {
    const auto begin = line.find_first_not_of(' ');
    if (begin == std::string::npos || !ends_with(line, '{') || line.find(')') == std::string::npos) return false;
    const std::string code = line.substr(begin);
    for (const char* type : kTypes)
        if (starts_with(code, std::string(type) + " ")) return false;
    return line.find("] = {") == std::string::npos;
}

bool is_statement(const std::string& line) { return line.find_first_not_of(' ') != std::string::npos && line[0] != '#'; }

/// Index of the line that ends the block of a head, or of the head where there is none. Heads may have several lines, so the
/// column of the closing brace follows from the first statement.
std::size_t end_of(const std::vector<std::string>& lines, std::size_t head) {
    std::size_t first = head + 1;
    while (first < lines.size() && !is_statement(lines[first])) ++first;
    if (first == lines.size()) return head;
    const auto indent = lines[first].find_first_not_of(' ');
    if (lines[first][indent] == '}' || indent < kIndent) return head;
    for (std::size_t n = first; n < lines.size(); ++n)
        if (is_statement(lines[n]) && lines[n].find_first_not_of(' ') == indent - kIndent && lines[n][indent - kIndent] == '}')
            return n;
    return head;
}

}  // namespace

std::vector<std::string> length_findings(const SourceFile& file) {
    std::vector<std::string> findings;
    const std::vector<std::string> lines = lines_of(code_only(file.text));
    if (static_cast<int>(lines.size()) > kMaxFileLines)
        findings.push_back(
            finding(file, kMaxFileLines + 1,
                    "the file has " + std::to_string(lines.size()) + " lines; split it at " + std::to_string(kMaxFileLines)));
    for (std::size_t head = 0; head < lines.size(); ++head) {
        if (!is_head(lines[head])) continue;
        const auto length = static_cast<int>(end_of(lines, head) - head + 1);
        if (length > kMaxFunctionLines)
            findings.push_back(finding(
                file, static_cast<int>(head + 1),
                "the function has " + std::to_string(length) + " lines; split it at " + std::to_string(kMaxFunctionLines)));
    }
    return findings;
}

}  // namespace tedavis::tests::layering
