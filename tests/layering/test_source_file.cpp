#include "tests/layering/source_file.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace tedavis::tests::layering::test_source_file {
namespace {

TEST(SourceFile, FindsIncludesWithTheirLines) {
    const SourceFile file{"bus/a.cpp", "#include \"bus/a.hpp\"\n\n  #  include <cmath>  // why\nint include = 0;\n"};
    const auto includes = includes_of(file);
    ASSERT_EQ(includes.size(), 2u);
    EXPECT_EQ(includes[0].name, "bus/a.hpp");
    EXPECT_FALSE(includes[0].angled);
    EXPECT_EQ(includes[1].line, 3);
    EXPECT_EQ(includes[1].name, "cmath");
    EXPECT_TRUE(includes[1].angled);
}

TEST(SourceFile, BlanksCommentsAndLiteralsAndKeepsLines) {
    const std::string text = "a /* throw\nthrow */ b // throw\n\"thr\\\"ow\" 'x' 1'000 R\"d(throw)\" \n)d\" c";
    const std::string code = code_only(text);
    EXPECT_EQ(code.size(), text.size());
    EXPECT_EQ(code.find("throw"), std::string::npos);
    EXPECT_EQ(std::count(code.begin(), code.end(), '\n'), 3);
    EXPECT_NE(code.find("1'000"), std::string::npos) << "a digit separator is no literal";
    EXPECT_EQ(code.back(), 'c');
}

TEST(SourceFile, KeepsCommentsAloneWithTheirLines) {
    const std::string text = "a /* one\ntwo */ b // three\n\"// throw\" R\"(/* throw */)\" 1'000 /// four";
    const std::string comments = comments_only(text);
    EXPECT_EQ(comments.size(), text.size());
    EXPECT_EQ(comments.find("throw"), std::string::npos);
    EXPECT_EQ(comments.find("000"), std::string::npos);
    for (const char* word : {"/* one", "two */", "// three", "/// four"}) EXPECT_EQ(comments.find(word), text.find(word)) << word;
    EXPECT_EQ(std::count(comments.begin(), comments.end(), '\n'), 2);
}

TEST(SourceFile, LiteralsThatNeverEndStopAtTheText) {
    for (const char* text : {"/* open", "R\"x(open", "R\"", "\"open", "'", "//"}) {
        EXPECT_EQ(code_only(text), std::string(std::string_view(text).size(), ' ')) << text;
    }
}

TEST(SourceFile, TokensCarryTheirLines) {
    const auto tokens = tokens_of({"bus/a.cpp", "std::vector<int>\n  x_1;"});
    ASSERT_EQ(tokens.size(), 9u);
    EXPECT_EQ(tokens[3].text, "vector");
    EXPECT_EQ(tokens[3].line, 1);
    EXPECT_EQ(tokens[7].text, "x_1");
    EXPECT_EQ(tokens[7].line, 2);
}

TEST(SourceFile, TheTreeHoldsItsOwnSources) {
    const auto files = read_tree(TEDAVIS_SOURCE_DIR);
    const auto has = [&](std::string_view path) {
        return std::any_of(files.begin(), files.end(), [&](const SourceFile& f) { return f.path == path; });
    };
    EXPECT_TRUE(has("tests/layering/test_source_file.cpp"));
    EXPECT_TRUE(has("render_core/base/result.hpp"));
    EXPECT_FALSE(has("CMakeLists.txt"));
}

TEST(SourceFile, PagesAreThoseOfThePresentState) {
    const auto pages = read_pages(TEDAVIS_SOURCE_DIR);
    const auto has = [&](std::string_view path) {
        return std::any_of(pages.begin(), pages.end(), [&](const SourceFile& page) { return page.path == path; });
    };
    EXPECT_TRUE(has("README.md"));
    EXPECT_TRUE(has("render_core/display/README.md"));
    EXPECT_TRUE(has("configs/designs/README.md"));
    EXPECT_FALSE(has("CHANGELOG.md"));
    EXPECT_FALSE(has("render_core/base/result.hpp"));
}

}  // namespace
}  // namespace tedavis::tests::layering::test_source_file
