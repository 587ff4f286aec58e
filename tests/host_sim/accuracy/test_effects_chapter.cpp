#include "host_sim/accuracy/effects_chapter.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tedavis::host_sim::test_effects_chapter {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

EffectUse made_use(const char* name, std::uint64_t run, std::uint64_t skipped) {
    EffectUse use;
    use.name = name;
    use.contribution = "color";
    use.asked = run + skipped;
    use.run = run;
    use.skipped = skipped;
    if (skipped > 0) use.reasons = {{"nothing <near>", skipped}};
    use.saved = {1.5, 0.25};
    use.largest_difference = 1;
    return use;
}

UncalledEffects made_effects() { return {"default", "es3-mid", 8, {made_use("air", 5, 3), made_use("drape", 8, 0)}}; }

TEST(EffectsChapter, HasARowForEachEffect) {
    const std::string page = effects_chapter(made_effects());
    EXPECT_THAT(page, HasSubstr("<th>air</th><td class='n'>8</td><td class='n'>5</td><td class='n'>0</td><td class='n'>3</td>"
                                "<td class='n'>1.50 +- 0.25</td><td class='n'>1 of 255</td><td class='n'>0</td>"));
    EXPECT_THAT(page, HasSubstr("nothing &lt;near&gt; (3)"));
    EXPECT_THAT(page, HasSubstr("<th>drape</th>"));
    EXPECT_THAT(page,
                HasSubstr("Of 2 effects 2 were drawn at least once, and 1 were left out or replaced at least once. 0 of them"));
    EXPECT_THAT(page, Not(HasSubstr("class='dominated'")));
}

TEST(EffectsChapter, MarksAnEffectThatIsMissed) {
    UncalledEffects effects = made_effects();
    effects.uses[0].largest_difference = 40;
    const std::string page = effects_chapter(effects);
    EXPECT_THAT(page, HasSubstr("<tr class='dominated'><th>air</th>"));
    EXPECT_THAT(page, HasSubstr("1 of them can be seen to be missing"));
}

TEST(UncalledText, NamesEffectsThatWereLeftOut) {
    const std::string text = uncalled_text(made_effects());
    EXPECT_THAT(text, HasSubstr("air: 3 without it, 1.50 +- 0.25 ms saved, 1 of 255"));
    EXPECT_THAT(text, Not(HasSubstr("drape")));
}

}  // namespace
}  // namespace tedavis::host_sim::test_effects_chapter
