#include "host_sim/evaluation/clutter_opinions.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "host_sim/evaluation/feature_congestion.hpp"
#include "host_sim/evaluation/picture_meter.hpp"
#include "host_sim/evaluation/subband_entropy.hpp"
#include "tests/host_sim/evaluation/rgba_of.hpp"
#include "tests/support/files/paths.hpp"
#include "tests/support/perception/golden_pictures.hpp"
#include "tests/support/perception/rank_correlation.hpp"

namespace tedavis::host_sim::test_clutter_opinions {
namespace {

TEST(ClutterOpinions, AreThoseOfTheMeasures) {
    const RgbaPicture picture = test_support::rgba_of(test_support::noise_picture(70, 50, 3));
    const MeasuredOpinions opinions = clutter_opinions(picture);
    const LabLevels levels(picture);
    const FeatureCongestion congestion = feature_congestion(levels);
    EXPECT_EQ(opinions.numbers.feature_congestion, congestion.mean);
    EXPECT_EQ(opinions.numbers.subband_entropy, subband_entropy(levels));
    ASSERT_EQ(opinions.congestion.values.size(), 70u * 50);
    for (std::size_t n = 0; n < congestion.map.values.size(); ++n)
        ASSERT_EQ(opinions.congestion.values[n], std::min(congestion.map.values[n] / kFullCongestion, 1.0f));
}

TEST(ClutterOpinions, AreToldInWords) {
    EXPECT_EQ(opinions_words({4.206, 3.971}), "Feature Congestion 4.21, Subband Entropy 3.97 bits");
    EXPECT_EQ(agreement_words(opinions_agreement({0.1, 0.2, 0.3}, {{1, 5}, {2, 4}, {3, 6}}), "peaks"),
              "Of 3 pairs of peaks Feature Congestion orders 3 as the edges do, Subband Entropy 2.");
    EXPECT_EQ(agreement_words(opinions_agreement({0.1, 0.2}, {{1, 5}, {2, 4}}), "pictures"),
              "Of 1 pair of pictures Feature Congestion orders 1 as the edges do, Subband Entropy 0.");
    EXPECT_EQ(agreement_words(opinions_agreement({0.1}, {{1, 5}}), "peaks"), "");
}

// Over pictures of the display three measures of the same thing go together, as the README says.
TEST(ClutterOpinions, GoWithTheEdgesOverThePicturesOfTheDisplay) {
    std::vector<double> edges, congestion, entropy;
    for (const auto& [name, picture] : test_support::golden_pictures(test_support::source_dir())) {
        const RgbaPicture rgba = test_support::rgba_of(picture);
        PictureMeter meter({});
        edges.push_back(meter.measure(rgba, name, nullptr, {}).clutter);
        const ClutterOpinions numbers = clutter_opinions(rgba).numbers;
        congestion.push_back(numbers.feature_congestion);
        entropy.push_back(numbers.subband_entropy);
    }
    ASSERT_GE(edges.size(), 30u);
    const double by_congestion = test_support::rank_correlation(edges, congestion),
                 by_entropy = test_support::rank_correlation(edges, entropy),
                 between = test_support::rank_correlation(congestion, entropy);
    RecordProperty("edges_congestion", std::to_string(by_congestion));
    RecordProperty("edges_entropy", std::to_string(by_entropy));
    RecordProperty("congestion_entropy", std::to_string(between));
    EXPECT_GT(by_congestion, 0.9);
    EXPECT_GT(by_entropy, 0.75);
    EXPECT_GT(between, 0.65);  // grain and colors that lie beside each other have congestion, but few subbands
}

}  // namespace
}  // namespace tedavis::host_sim::test_clutter_opinions
