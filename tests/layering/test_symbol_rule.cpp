#include "tests/layering/symbol_rule.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "tests/layering/source_file.hpp"

namespace tedavis::tests::layering::test_symbol_rule {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

std::string nm(const std::filesystem::path& archive) {
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> pipe(popen(("nm -A -u '" + archive.string() + "'").c_str(), "r"),
                                                               pclose);
    std::string output;
    if (!pipe) return output;
    std::array<char, 4096> part;
    while (const auto size = std::fread(part.data(), 1, part.size(), pipe.get())) output.append(part.data(), size);
    return output;
}

std::vector<std::filesystem::path> archives(std::string_view beginning) {
    std::vector<std::filesystem::path> found;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(TEDAVIS_BINARY_DIR)) {
        const auto name = entry.path().filename().string();
        if (entry.path().extension() == ".a" && starts_with(name, beginning)) found.push_back(entry.path());
    }
    return found;
}

TEST(SymbolRule, ReadsWhatNmWrites) {
    const auto symbols =
        parse_nm("build/lib x.a:check.cpp.o:                 U abort\n/b/y.a:z.cpp.o:     w __cxa_pure_virtual\nnoise\n");
    ASSERT_EQ(symbols.size(), 2u);
    EXPECT_EQ(symbols[0].member, "check.cpp.o");
    EXPECT_EQ(symbols[0].name, "abort");
    EXPECT_EQ(symbols[1].member, "z.cpp.o");
}

TEST(SymbolRule, FindsEverySeededSymbol) {
    for (const char* name : {"malloc", "_Znwm", "_ZnamRKSt9nothrow_t", "__cxa_throw", "__dynamic_cast", "clock_gettime", "fopen",
                             "_ZNSt6chrono3_V212system_clock3nowEv", "glGetString", "eglGetDisplay"}) {
        EXPECT_THAT(symbol_findings({{"a.cpp.o", name}}), ElementsAre(HasSubstr(name)));
    }
    for (const char* name : {"abort", "memcpy", "_ZdlPvm", "global", "sqrt", "_ZN7tedavis4base5crc32EPKvm"}) {
        EXPECT_THAT(symbol_findings({{"a.cpp.o", name}}), IsEmpty());
    }
}

TEST(SymbolRule, LetsStartUpObjectsUseTheHeapOnly) {
    EXPECT_THAT(symbol_findings({{"config_reader.cpp.o", "_Znwm"}}), IsEmpty());
    EXPECT_THAT(symbol_findings({{"config_reader.cpp.o", "__cxa_throw"}}), Not(IsEmpty()));
}

TEST(SymbolRule, SeesTheHeapOfTheDeskSimulator) {
    const auto found = archives("libtedavis_host_sim");
    ASSERT_FALSE(found.empty());
    EXPECT_THAT(symbol_findings(parse_nm(nm(found.front()))), Not(IsEmpty()));
}

TEST(SymbolRule, HoldsOverTheCompiledCore) {
    auto core = archives("libtedavis_render_core_");
    const auto bus = archives("libtedavis_bus");
    core.insert(core.end(), bus.begin(), bus.end());
    ASSERT_FALSE(core.empty());
    for (const auto& archive : core) {
        const auto symbols = parse_nm(nm(archive));
        EXPECT_THAT(symbols, Not(IsEmpty())) << archive;
        EXPECT_THAT(symbol_findings(symbols), IsEmpty()) << archive;
    }
}

}  // namespace
}  // namespace tedavis::tests::layering::test_symbol_rule
