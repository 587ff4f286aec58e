#include "tests/layering/length_rule.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tedavis::tests::layering::test_length_rule {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::string repeated(const std::string& line, int times) {
    std::string text;
    for (int n = 0; n < times; ++n) text += line;
    return text;
}

/// A function of so many lines, between others, with braces in strings and comments that end nothing.
std::string function_of(int lines) {
    return "int one() { return 1; }\n\nint long_one(int a) {\n" + repeated("    f(\"}\");  // }\n", lines - 2) + "}\n";
}

TEST(LengthRule, AFunctionMayHaveSixtyLines) {
    EXPECT_THAT(length_findings({"bus/a.cpp", function_of(60)}), IsEmpty());
    EXPECT_THAT(length_findings({"bus/a.cpp", function_of(61)}),
                ElementsAre(HasSubstr("bus/a.cpp:3: the function has 61 lines")));
}

TEST(LengthRule, MembersAndBlocksCountToo) {
    const std::string member = "class A {\n    void f() {\n" + repeated("        g();\n", 70) + "    }\n};\n";
    EXPECT_THAT(length_findings({"bus/a.hpp", member}), ElementsAre(HasSubstr("bus/a.hpp:2: ")));
}

TEST(LengthRule, HeadsMayHaveSeveralLines) {
    const std::string lines = repeated("        g();\n", 70);
    const std::string constructor = "class A {\n    A(int a)\n        : a_(a) {\n" + lines + "    }\n};\n";
    EXPECT_THAT(length_findings({"bus/a.hpp", constructor}), ElementsAre(HasSubstr("bus/a.hpp:3: the function has 72 lines")));
    const std::string parameters = "void f(int a,\n       int b) {\n" + repeated("    g();\n", 70) + "}\n";
    EXPECT_THAT(length_findings({"bus/a.cpp", parameters}), ElementsAre(HasSubstr("bus/a.cpp:2: the function has 72 lines")));
}

TEST(LengthRule, TablesTypesAndNamespacesMayBeLonger) {
    for (const char* head : {"constexpr int kTable[] = {\n", "namespace a {\n", "struct A final : B<decltype(f())> {\n"})
        EXPECT_THAT(length_findings({"bus/a.cpp", head + repeated("    1,\n", 100) + "};\n"}), IsEmpty()) << head;
}

TEST(LengthRule, AFileMayHaveFourHundredLines) {
    EXPECT_THAT(length_findings({"bus/a.cpp", repeated("int a;\n", 400)}), IsEmpty());
    EXPECT_THAT(length_findings({"bus/a.cpp", repeated("int a;\n", 401)}), ElementsAre(HasSubstr("the file has 401 lines")));
}

TEST(LengthRule, HoldsOverTheProductAndItsShaders) {
    for (const SourceFile& file : read_tree(TEDAVIS_SOURCE_DIR)) {
        if (starts_with(file.path, "tests/")) continue;
        EXPECT_THAT(length_findings(file), IsEmpty());
    }
    const auto shaders = read_shaders(TEDAVIS_SOURCE_DIR);
    ASSERT_GT(shaders.size(), 40u);
    for (const SourceFile& file : shaders) EXPECT_THAT(length_findings(file), IsEmpty());
}

}  // namespace
}  // namespace tedavis::tests::layering::test_length_rule
