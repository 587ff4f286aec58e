#include "host_sim/tracing/require_pageable.hpp"

#include <gtest/gtest.h>

#include "host_sim/tracing/chosen_shot.hpp"
#include "tests/support/flights/flown_circle.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_require_pageable {
namespace {

TEST(RequirePageable, SaysWhatNeedsAllHeightsAndWhatToDo) {
    const test_support::FlownFiles files;
    base::SerialWorkers workers;
    const raytrace::TraceSettings quality = settings_of(TracePreset::quality);
    const TracedGround ground(files.terrain, workers, {200'000, {quality}});
    ASSERT_TRUE(ground.is_paged());
    const auto require = [&](const std::vector<raytrace::TraceSettings>& settings) {
        return [&ground, settings] { require_pageable(ground, "--preset quality", settings); };
    };
    const std::string needs =
        files.terrain + ": the smooth surface, supersampling, apertures, cast shadows and mirrors of --preset quality";
    test_support::expect_user_error(require({quality}), needs);
    test_support::expect_user_error(require(choice_levels()), needs.substr(0, needs.find(':')));
    test_support::expect_user_error(require({quality}), "--memory allows 0.2 MB; give --memory 0.");
    EXPECT_NO_THROW(require({settings_of(TracePreset::time)})());
    raytrace::TraceSettings searched = settings_of(TracePreset::time);
    searched.search = raytrace::usual_search(raytrace::SearchKind::cells);
    test_support::expect_user_error(require({searched}), ": the search of ");
}

TEST(RequirePageable, AllowsEverythingInMemory) {
    const test_support::FlownFiles files;
    base::SerialWorkers workers;
    const TracedGround ground(files.terrain, workers);
    EXPECT_NO_THROW(require_pageable(ground, "--preset quality", {settings_of(TracePreset::quality)}));
}

}  // namespace
}  // namespace tedavis::host_sim::test_require_pageable
