// The sources of the tree as the layering checks see them. Host code for tests: may throw.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace tedavis::tests::layering {

/// A file by its path from the root of the tree, with forward slashes.
struct SourceFile {
    std::string path;
    std::string text;
};

struct IncludeLine {
    int line = 0;
    std::string name;     ///< what stands between the quotes or brackets
    bool angled = false;  ///< <name> rather than "name"
};

struct Token {
    int line = 0;
    std::string text;  ///< an identifier, a number or one character
};

/// All C++ sources below `root` in the folders that the house knows, sorted by path. Throws where the tree cannot be read.
std::vector<SourceFile> read_tree(const std::filesystem::path& root);

/// All shaders below `root`, sorted by path. Throws where the tree cannot be read.
std::vector<SourceFile> read_shaders(const std::filesystem::path& root);

/// All pages (*.md) below `root` that describe the present state, sorted by path: CHANGELOG.md is none of them. Throws where the
/// tree cannot be read.
std::vector<SourceFile> read_pages(const std::filesystem::path& root);

std::vector<IncludeLine> includes_of(const SourceFile& file);

/// The text without comments, string and character literals; lines keep their numbers.
std::string code_only(std::string_view text);

/// The comments of a text with their marks; lines keep their numbers.
std::string comments_only(std::string_view text);

std::vector<Token> tokens_of(const SourceFile& file);

bool starts_with(std::string_view text, std::string_view prefix);

/// "path:line: sentence", the form of every finding.
std::string finding(const SourceFile& file, int line, const std::string& message);

}  // namespace tedavis::tests::layering
