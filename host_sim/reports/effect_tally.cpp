#include "host_sim/reports/effect_tally.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace tedavis::host_sim {
namespace {

void count_reason(std::string_view reason, std::vector<EffectReason>& reasons) {
    for (EffectReason& known : reasons)
        if (known.text == reason) {
            ++known.frames;
            return;
        }
    reasons.push_back({std::string(reason), 1});
}

/// Several elements of the data may ask for one effect in a frame. The frame has it where one of them has it.
bool is_of_frame(const display::FrameRecord& record, const display::EffectRecord& effect) {
    for (const display::EffectRecord& other : record.effects) {
        if (other.name != effect.name) continue;
        if (other.state < effect.state || (other.state == effect.state && &other < &effect)) return false;
    }
    return true;
}

}  // namespace

void EffectCount::add(const display::EffectRecord& record) {
    ++asked;
    if (record.state == display::EffectState::run) {
        ++run;
        return;
    }
    ++(record.state == display::EffectState::replaced ? replaced : skipped);
    count_reason(record.reason.view(), reasons);
    skipped_work += record.draws + record.passes + record.bytes;
    bound = std::max(bound, record.bound);
}

void EffectTally::add(const display::FrameRecord& record) {
    static_assert(display::EffectState::run < display::EffectState::replaced &&
                  display::EffectState::replaced < display::EffectState::skipped);
    for (const display::EffectRecord& effect : record.effects) {
        if (!is_of_frame(record, effect)) continue;
        const auto known = std::find_if(counts_.begin(), counts_.end(),
                                        [&](const EffectCount& count) { return effect.name.view() == count.name; });
        EffectCount& count = known != counts_.end() ? *known : counts_.emplace_back();
        count.name = effect.name.view();
        count.add(effect);
    }
}

nlohmann::ordered_json effect_count_json(const EffectCount& count) {
    nlohmann::ordered_json reasons = nlohmann::ordered_json::array();
    for (const EffectReason& reason : count.reasons) reasons.push_back({{"why", reason.text}, {"frames", reason.frames}});
    return {{"name", count.name},
            {"asked", count.asked},
            {"run", count.run},
            {"replaced", count.replaced},
            {"skipped", count.skipped},
            {"reasons", std::move(reasons)},
            {"skipped_work", count.skipped_work},
            {"bound", count.bound}};
}

EffectCount effect_count_from(const nlohmann::ordered_json& json) {
    EffectCount count;
    count.name = json.at("name");
    count.asked = json.at("asked");
    count.run = json.at("run");
    count.replaced = json.at("replaced");
    count.skipped = json.at("skipped");
    for (const nlohmann::ordered_json& reason : json.at("reasons"))
        count.reasons.push_back({reason.at("why"), reason.at("frames")});
    count.skipped_work = json.at("skipped_work");
    count.bound = json.at("bound");
    return count;
}

}  // namespace tedavis::host_sim
