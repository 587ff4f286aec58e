#include "tests/layering/word_rule.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tedavis::tests::layering::test_word_rule {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

struct Seed {
    const char* path;
    const char* code;
};

void PrintTo(const Seed& seed, std::ostream* out) { *out << seed.path << ": " << seed.code; }

class RefusedWord : public ::testing::TestWithParam<Seed> {};

TEST_P(RefusedWord, IsFoundWithItsLine) {
    const SourceFile file{GetParam().path, std::string("// a comment\n") + GetParam().code + "\n"};
    EXPECT_THAT(word_findings(file), ElementsAre(HasSubstr(std::string(GetParam().path) + ":2: ")));
}

INSTANTIATE_TEST_SUITE_P(
    FlightCode, RefusedWord,
    ::testing::Values(
        Seed{"render_core/base/a.cpp", "void f() { throw 1; }"}, Seed{"bus/a.cpp", "auto* p = dynamic_cast<T*>(q);"},
        Seed{"target/a.cpp", "auto& t = typeid(x);"}, Seed{"render_core/a.cpp", "int* p = new int;"},
        Seed{"render_core/a.cpp", "int* p = new (std::nothrow) int;"}, Seed{"bus/a.cpp", "void* p = malloc(8);"},
        Seed{"bus/a.cpp", "std::vector<int> v;"}, Seed{"render_core/a.cpp", "std::string s;"},
        Seed{"render_core/a.cpp", "auto p = std::make_unique<int>();"}, Seed{"bus/a.cpp", "namespace c = std::chrono;"},
        Seed{"render_core/a.cpp", "clock_gettime(CLOCK_MONOTONIC, &t);"}, Seed{"bus/a.cpp", "auto t = std::time(nullptr);"},
        Seed{"render_core/a.cpp", "auto* f = std::fopen(name, mode);"}, Seed{"bus/a.cpp", "std::ifstream f;"}));

TEST(WordRule, LeavesOtherCodeAlone) {
    const std::string allowed[] = {
        "new (place) T;",        "// throw new std::vector", "const char* s = \"throw\";", "int renew = time + clock;",
        "T(const T&) = delete;", "std::string_view s;"};
    for (const std::string& code : allowed) EXPECT_THAT(word_findings({"render_core/a.cpp", code}), IsEmpty()) << code;
    EXPECT_THAT(word_findings({"host_sim/a.cpp", "throw std::runtime_error(std::string());"}), IsEmpty());
    EXPECT_THAT(word_findings({"platform/clock/a.cpp", "clock_gettime(CLOCK_MONOTONIC, &t);"}), IsEmpty());
}

TEST(WordRule, FindsUnfinishedWorkAndUnguardedHeaders) {
    EXPECT_THAT(word_findings({"host_sim/a.cpp", std::string("// TO") + "DO later"}), ElementsAre(HasSubstr("unfinished")));
    EXPECT_THAT(word_findings({"host_sim/a.hpp", "int x;"}), ElementsAre(HasSubstr("#pragma once")));
    EXPECT_THAT(word_findings({"host_sim/a.hpp", "#pragma once\nint x;"}), IsEmpty());
}

TEST(WordRule, HoldsOverTheTree) {
    for (const SourceFile& file : read_tree(TEDAVIS_SOURCE_DIR)) EXPECT_THAT(word_findings(file), IsEmpty());
}

}  // namespace
}  // namespace tedavis::tests::layering::test_word_rule
