#include "tests/layering/source_file.hpp"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <regex>
#include <sstream>
#include <stdexcept>

namespace tedavis::tests::layering {
namespace {

constexpr const char* kFolders[] = {"render_core", "bus", "platform", "target", "host_sim", "tests", "toolchains"};
constexpr const char* kPageFolders[] = {"render_core", "bus", "platform", "target", "host_sim", "configs", "tests"};
constexpr const char* kPages[] = {"README.md", "CONTRIBUTING.md", "GLOSSARY.md"};

bool is_source(const std::filesystem::path& path) {
    const auto extension = path.extension();
    return extension == ".cpp" || extension == ".hpp" || extension == ".inc";
}

bool is_shader(const std::filesystem::path& path) { return path.extension() == ".frag" || path.extension() == ".vert"; }

bool is_page(const std::filesystem::path& path) { return path.extension() == ".md"; }

std::string read_text(const std::filesystem::path& path) {
    std::ifstream stream(path, std::ios::binary);
    if (!stream) throw std::runtime_error("cannot read " + path.string());
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

enum class TextPart { code, comment, literal };

// Walks over a source text and blanks all but one part of it.
class Blanker {
public:
    Blanker(std::string_view text, TextPart kept) : text_(text), kept_(kept) {}

    std::string run() {
        while (at_ < text_.size()) {
            if (ahead("//")) {
                take_until("\n", false, TextPart::comment);
            } else if (ahead("/*")) {
                take_until("*/", true, TextPart::comment);
            } else if (ahead("R\"") && !after_word()) {
                take_raw_string();
            } else if (text_[at_] == '"' || (text_[at_] == '\'' && !after_word())) {
                take_literal(text_[at_]);
            } else {
                take_to(at_ + 1, TextPart::code);
            }
        }
        return out_;
    }

private:
    bool ahead(std::string_view what) const { return text_.substr(at_, what.size()) == what; }
    bool after_word() const { return at_ > 0 && is_word(text_[at_ - 1]); }

    void take_to(std::size_t end, TextPart part) {
        for (end = std::min(end, text_.size()); at_ < end; ++at_) out_ += part == kept_ || text_[at_] == '\n' ? text_[at_] : ' ';
    }

    void take_until(std::string_view end, bool with_end, TextPart part) {
        const auto found = text_.find(end, at_ + 2);
        take_to(found == std::string_view::npos ? text_.size() : found + (with_end ? end.size() : 0), part);
    }

    void take_raw_string() {
        const auto open = text_.find('(', at_);
        if (open == std::string_view::npos) return take_to(text_.size(), TextPart::literal);
        take_until(")" + std::string(text_.substr(at_ + 2, open - at_ - 2)) + "\"", true, TextPart::literal);
    }

    void take_literal(char quote) {
        auto end = at_ + 1;
        while (end < text_.size() && text_[end] != quote && text_[end] != '\n') end += text_[end] == '\\' ? 2 : 1;
        take_to(end + 1, TextPart::literal);
    }

    std::string_view text_;
    TextPart kept_;
    std::size_t at_ = 0;
    std::string out_;
};

void add_files(const std::filesystem::path& root, const char* folder, bool (*is_wanted)(const std::filesystem::path&),
               std::vector<SourceFile>& files) {
    if (!std::filesystem::is_directory(root / folder)) return;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root / folder)) {
        if (!entry.is_regular_file() || !is_wanted(entry.path())) continue;
        files.push_back({entry.path().lexically_relative(root).generic_string(), read_text(entry.path())});
    }
}

void sort_by_path(std::vector<SourceFile>& files) {
    std::sort(files.begin(), files.end(), [](const SourceFile& a, const SourceFile& b) { return a.path < b.path; });
}

}  // namespace

std::vector<SourceFile> read_tree(const std::filesystem::path& root) {
    std::vector<SourceFile> files;
    for (const char* folder : kFolders) add_files(root, folder, is_source, files);
    sort_by_path(files);
    return files;
}

std::vector<SourceFile> read_shaders(const std::filesystem::path& root) {
    std::vector<SourceFile> files;
    add_files(root, "render_core", is_shader, files);
    sort_by_path(files);
    return files;
}

std::vector<SourceFile> read_pages(const std::filesystem::path& root) {
    std::vector<SourceFile> files;
    for (const char* page : kPages) files.push_back({page, read_text(root / page)});
    for (const char* folder : kPageFolders) add_files(root, folder, is_page, files);
    sort_by_path(files);
    return files;
}

std::vector<IncludeLine> includes_of(const SourceFile& file) {
    static const std::regex pattern(R"re(^\s*#\s*include\s*([<"])([^>"]+)[>"].*)re");
    std::vector<IncludeLine> includes;
    std::istringstream lines(file.text);
    std::string line;
    for (int number = 1; std::getline(lines, line); ++number) {
        std::smatch match;
        if (line.find("include") == std::string::npos || !std::regex_match(line, match, pattern)) continue;
        includes.push_back({number, match[2], match[1] == "<"});
    }
    return includes;
}

std::string code_only(std::string_view text) { return Blanker(text, TextPart::code).run(); }

std::string comments_only(std::string_view text) { return Blanker(text, TextPart::comment).run(); }

std::vector<Token> tokens_of(const SourceFile& file) {
    const std::string code = code_only(file.text);
    std::vector<Token> tokens;
    int line = 1;
    for (std::size_t i = 0; i < code.size();) {
        if (code[i] == '\n') ++line;
        if (std::isspace(static_cast<unsigned char>(code[i])) != 0) {
            ++i;
            continue;
        }
        auto end = i + 1;
        if (is_word(code[i])) {
            while (end < code.size() && is_word(code[end])) ++end;
        }
        tokens.push_back({line, code.substr(i, end - i)});
        i = end;
    }
    return tokens;
}

bool starts_with(std::string_view text, std::string_view prefix) { return text.substr(0, prefix.size()) == prefix; }

std::string finding(const SourceFile& file, int line, const std::string& message) {
    return file.path + ":" + std::to_string(line) + ": " + message;
}

}  // namespace tedavis::tests::layering
