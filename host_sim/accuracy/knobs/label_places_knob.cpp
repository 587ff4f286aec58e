#include "host_sim/accuracy/knobs/label_places_knob.hpp"

#include "host_sim/accuracy/knobs/crowded_signs.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

constexpr std::uint8_t kStemLevels[] = {1, 2, 3, 5, draw::kSignStems};
constexpr std::size_t kCrowdsOfPart = 50, kLabelParts = 20, kFewLabelParts = 4, kPlannerBytes = 1u << 16;

KnobFacts label_places_facts() {
    std::vector<KnobLevel> levels;
    for (const std::uint8_t stems : kStemLevels) {
        const std::size_t places = stems * std::size(draw::kNameSides);
        levels.push_back({std::to_string(places) + " places", static_cast<double>(places)});
    }
    return {"label_places",
            "Places that a name may take beside its icon",
            "draw::sign_stems(): 7 stems of 3 sides, obstacles 1 stem; no design changes it",
            "names that have room, but are not placed, of 8 signs that crowd 220 x 130 pixels",
            "% of the names",
            {"the most names that have room at once, found by trying all places", 0, "the search leaves nothing out"},
            "none: the search is exhaustive; a test compares it with crowds whose answer is known",
            "What warns has its marker at every level.",
            "places of a name",
            std::nullopt,
            std::move(levels)};
}

class LabelPlacesKnob final : public Knob {
public:
    explicit LabelPlacesKnob(const KnobGround& ground)
        : Knob(label_places_facts()), parts_(ground.is_quick ? kFewLabelParts : kLabelParts), memory_(kPlannerBytes) {
        base::Arena arena(memory_.data(), memory_.size());
        if (!planner_.start(arena)) throw UserError("no memory for the planner of labels");
        SeededRandom numbers(24);
        for (std::size_t n = 0; n < parts_ * kCrowdsOfPart; ++n) crowds_.emplace_back(numbers);
        for (const CrowdedSigns& crowd : crowds_) most_.push_back(crowd.most_names());
    }

    [[nodiscard]] std::size_t samples() const override { return parts_; }
    void run(std::size_t level, std::size_t sample) override {
        for (std::size_t n = 0; n < kCrowdsOfPart; ++n) place(level, sample * kCrowdsOfPart + n);
    }
    void find_errors(std::size_t level, std::size_t sample, std::vector<double>& errors) override {
        for (std::size_t n = sample * kCrowdsOfPart; n < (sample + 1) * kCrowdsOfPart; ++n) {
            place(level, n);
            double named = 0;
            for (const draw::Label& label : planner_.labels()) named += label.level == draw::LabelLevel::name ? 1 : 0;
            errors.push_back(100 * (most_[n] - named) / CrowdedSigns::kCount);
        }
    }
    [[nodiscard]] std::string place_of(std::size_t sample, std::size_t error) const override {
        return "crowd " + std::to_string(sample * kCrowdsOfPart + error);
    }

private:
    void place(std::size_t level, std::size_t n) {
        CrowdedSigns& crowd = crowds_[n];
        crowd.allow(kStemLevels[level]);
        planner_.forget();
        planner_.begin(CrowdedSigns::kInterval, {});
        static_cast<void>(planner_.add_group({}));
        for (std::uint32_t sign = 0; sign < CrowdedSigns::kCount; ++sign)
            planner_.offer(draw::label_key(0, sign), 1, 1 - static_cast<double>(sign) / CrowdedSigns::kCount);
        planner_.settle(crowd);
    }

    std::size_t parts_;
    std::vector<unsigned char> memory_;
    draw::LabelPlanner planner_;
    std::vector<CrowdedSigns> crowds_;
    std::vector<std::uint32_t> most_;  ///< names, by crowd
};

}  // namespace

std::unique_ptr<Knob> make_label_places_knob(const KnobGround& ground) { return std::make_unique<LabelPlacesKnob>(ground); }

}  // namespace tedavis::host_sim
