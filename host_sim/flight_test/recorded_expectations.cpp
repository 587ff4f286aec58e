#include "host_sim/flight_test/recorded_expectations.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <set>

#include "host_sim/flight_test/read_conditions.hpp"

namespace tedavis::host_sim {
namespace {

constexpr double kRoundedPart = 1e-6;  // of the step to which times are written, by which a sum of times may miss it
constexpr double kBeforeEnd_s = 0.001;
constexpr int kLastPlace = 30;
constexpr std::size_t kNamesInWords = 6;
constexpr std::array<const char*, 8> kKindWords = {"phases",          "phase sources", "designs", "terrain alerts",
                                                   "obstacle alerts", "signals",       "flags",   "effects"};

/// The steps to which times are written: half a frame at most.
class TimeSteps {
public:
    explicit TimeSteps(double rate_hz) : per_s_(rate_hz <= kFastestOfHundredths_hz ? 100 : 1000) {}

    [[nodiscard]] double at_or_after(double time_s) const {
        return std::ceil(time_s * per_s_ - kRoundedPart) / per_s_ + 0.0;  // never -0
    }
    [[nodiscard]] double at_or_before(double time_s) const { return std::floor(time_s * per_s_ + kRoundedPart) / per_s_; }

private:
    static constexpr double kFastestOfHundredths_hz = 50;
    double per_s_;
};

std::string time_words(double time_s) {
    char text[32];
    std::snprintf(text, sizeof text, "%.2f s", time_s);
    return text;
}

const char* flag_words(bool is_there, bool is_new) {
    if (is_new) return is_there ? " appears" : " goes";
    return is_there ? " stays" : " is not there";
}

/// "approach.none" in words.
std::string phase_words(const std::string& phase) {
    const std::size_t dot = phase.rfind(kNoSubPhase);
    return dot == std::string::npos ? phase : phase.substr(0, dot) + " without a sub-phase";
}

std::string effect_words(const std::string& state) { return state == "run" ? " runs" : " is " + state; }

std::string alert_words(const std::string& of_what, const std::string& level, bool is_new) {
    if (level == "not_watching") return "no " + of_what + " alert " + (is_new ? "is possible any more" : "is possible");
    return "the " + of_what + " alert" + (is_new ? " becomes " : " stays ") + level;
}

/// "the phase becomes cruise", or "stays"
std::string fact_words(const RecordedFact& fact, bool is_new) {
    const std::string turns = (is_new ? " becomes " : " stays ") + fact.value;
    switch (fact.kind) {
        case FactKind::phase: return std::string("the phase") + (is_new ? " becomes " : " stays ") + phase_words(fact.value);
        case FactKind::phase_source: return "its source" + turns;
        case FactKind::design: return "the design" + turns;
        case FactKind::alert: return alert_words("terrain", fact.value, is_new);
        case FactKind::obstacle_alert: return alert_words("obstacle", fact.value, is_new);
        case FactKind::flag: return "the flag " + fact.name + flag_words(fact.value == kFlagThere, is_new);
        case FactKind::effect: return "the effect " + fact.name + effect_words(fact.value);
        case FactKind::signal: break;
    }
    return fact.name + turns;
}

std::string facts_words(const std::vector<RecordedFact>& facts, bool is_new) {
    std::string words;
    for (std::size_t n = 0; n < facts.size() && n < kNamesInWords; ++n)
        words += (n > 0 ? ", " : "") + fact_words(facts[n], is_new);
    return words + (facts.size() > kNamesInWords ? ", and " + std::to_string(facts.size() - kNamesInWords) + " more" : "");
}

using FactKey = std::pair<FactKind, std::string>;

/// Changes that belong together.
struct ChangeCluster {
    double first_s = 0, last_s = 0;
    std::set<FactKey> keys;
};

struct FactChange {
    double time_s = 0;
    FactKey key;
};

struct WeighedExpectation {
    RecordedExpectation expectation;
    int place = kLastPlace;  ///< of the most important of its facts
    double lasts_s = 0;
};

bool is_headline(FactKind kind) { return kind <= FactKind::design; }

/// In the order of importance, from 0.
int place_of(const RecordedFact& fact) {
    const bool is_alert = fact.kind == FactKind::alert || fact.kind == FactKind::obstacle_alert;
    const bool is_quiet = is_alert && (fact.value == "none" || fact.value == "not_watching");
    const bool is_normal = is_quiet || fact.value == "valid" || fact.value == "missing" || fact.value == kFlagGone;
    constexpr int kNormal = 10;  // after all that is out of the ordinary, but for effects
    if (fact.kind == FactKind::effect) return kLastPlace;
    return static_cast<int>(fact.kind) + (is_normal && !is_headline(fact.kind) ? kNormal : 0);
}

std::vector<FactChange> changes_of(const std::vector<FactSpan>& spans, double frame_s) {
    std::vector<FactChange> changes;
    for (const FactSpan& span : spans) {
        if (!span.from_start) changes.push_back({span.first_s, {span.fact.kind, span.fact.name}});
        if (!span.to_end) changes.push_back({span.last_s + frame_s, {span.fact.kind, span.fact.name}});
    }
    std::sort(changes.begin(), changes.end(), [](const FactChange& a, const FactChange& b) { return a.time_s < b.time_s; });
    return changes;
}

/// Joined in the order of time. Changes of one frame stay together: a value that ends there never meets one that begins there.
std::vector<ChangeCluster> clusters_of(const std::vector<FactSpan>& spans, const RecordingRule& rule) {
    const std::vector<FactChange> changes = changes_of(spans, 1 / rule.rate_hz);
    const double same_s = 0.5 / rule.rate_hz;
    std::vector<ChangeCluster> clusters;
    for (std::size_t n = 0; n < changes.size();) {
        ChangeCluster next{changes[n].time_s, changes[n].time_s, {}};
        for (; n < changes.size() && changes[n].time_s - next.first_s < same_s; ++n) next.keys.insert(changes[n].key);
        const bool joins = !clusters.empty() && next.first_s - clusters.back().first_s <= rule.margin_s + same_s &&
                           std::none_of(next.keys.begin(), next.keys.end(),
                                        [&](const FactKey& key) { return clusters.back().keys.count(key) > 0; });
        if (!joins) {
            clusters.push_back(std::move(next));
            continue;
        }
        clusters.back().last_s = next.last_s;
        clusters.back().keys.merge(next.keys);
    }
    return clusters;
}

class ExpectationMaker {
public:
    ExpectationMaker(const FactTracks& tracks, const RecordingRule& rule)
        : rule_(rule),
          steps_(rule.rate_hz),
          first_s_(tracks.first_s()),
          latest_s_(steps_.at_or_before(tracks.last_s() - kBeforeEnd_s)),
          spans_(tracks.spans()) {
        clusters_ = clusters_of(spans_, rule);
    }

    std::vector<WeighedExpectation> make() {
        std::map<std::size_t, std::vector<const FactSpan*>> beginning;
        std::map<std::pair<std::size_t, std::size_t>, std::vector<const FactSpan*>> lasting;
        for (const FactSpan& span : spans_) {
            if (span.from_start && span.fact.value == "missing") continue;  // its first message is yet to come
            const std::size_t begin = span.from_start ? kNoCluster : cluster_at(span.first_s, key_of(span));
            const std::size_t end = span.to_end ? kNoCluster : cluster_at(span.last_s + 1 / rule_.rate_hz, key_of(span));
            if (begin != kNoCluster) beginning[begin].push_back(&span);
            std::size_t from = begin;
            for (const std::size_t cut : cuts_between(span, begin, end)) {
                lasting[{from, cut}].push_back(&span);
                from = cut;
            }
        }
        for (const auto& [cluster, spans] : beginning) add_change(clusters_[cluster], spans);
        for (const auto& [ends, spans] : lasting) add_lasting(ends.first, ends.second, spans);
        return std::move(made_);
    }

private:
    static constexpr std::size_t kNoCluster = static_cast<std::size_t>(-1);

    /// Phase, source and design are expected together, from one change of them to the next. The last cut is the end.
    [[nodiscard]] std::vector<std::size_t> cuts_between(const FactSpan& span, std::size_t begin, std::size_t end) const {
        std::vector<std::size_t> cuts;
        const std::size_t after = begin == kNoCluster ? 0 : begin + 1;
        for (std::size_t n = after; is_headline(span.fact.kind) && n < std::min(end, clusters_.size()); ++n)
            if (is_headline(clusters_[n].keys.begin()->first)) cuts.push_back(n);
        cuts.push_back(end);
        return cuts;
    }

    static FactKey key_of(const FactSpan& span) { return {span.fact.kind, span.fact.name}; }

    [[nodiscard]] std::size_t cluster_at(double time_s, const FactKey& key) const {
        const double same_s = 0.5 / rule_.rate_hz;
        const auto found = std::partition_point(clusters_.begin(), clusters_.end(),
                                                [&](const ChangeCluster& one) { return one.last_s < time_s - same_s; });
        for (auto one = found; one != clusters_.end() && one->first_s < time_s + same_s; ++one)
            if (one->keys.count(key) > 0) return static_cast<std::size_t>(one - clusters_.begin());
        return kNoCluster;
    }

    /// When a frame last showed the same before a span began; before the recording where none did.
    [[nodiscard]] double shown_before_s(const FactSpan& span) const {
        double last_s = first_s_ - 1;
        for (const FactSpan& other : spans_)
            if (key_of(other) == key_of(span) && other.fact.value == span.fact.value && other.last_s < span.first_s)
                last_s = std::max(last_s, other.last_s);
        return last_s;
    }

    /// From when on a change is waited for: in the last frame up to then, one of the facts that come last must not hold yet.
    [[nodiscard]] double awaited_from_s(const ChangeCluster& cluster, const std::vector<const FactSpan*>& spans) const {
        const FactSpan* last = spans.front();
        for (const FactSpan* const span : spans)
            if (span->first_s > last->first_s) last = span;
        const double frame_s = 1 / rule_.rate_hz;
        const double from_s = steps_.at_or_before(cluster.first_s - std::max(rule_.margin_s, frame_s));
        return std::max(from_s, steps_.at_or_after(std::max(shown_before_s(*last) + frame_s, first_s_)));
    }

    /// What becomes true by changes that belong together.
    void add_change(const ChangeCluster& cluster, const std::vector<const FactSpan*>& spans) {
        const double reach_s = std::max(rule_.margin_s, 1 / rule_.rate_hz);
        if (cluster.last_s > latest_s_ || cluster.first_s < first_s_ + reach_s) return;
        WeighedExpectation one = weighed(spans);
        one.expectation.kind = WindowKind::within;
        one.expectation.from_s = awaited_from_s(cluster, spans);
        one.expectation.to_s = std::min(steps_.at_or_after(cluster.last_s + rule_.margin_s), latest_s_);
        one.expectation.words = time_words(cluster.first_s) + ": " + facts_words(one.expectation.facts, true) + ".";
        made_.push_back(std::move(one));
    }

    void add_lasting(std::size_t begin, std::size_t end, const std::vector<const FactSpan*>& spans) {
        const double from_s = begin == kNoCluster ? first_s_ : clusters_[begin].last_s + rule_.margin_s;
        const double to_s = end == kNoCluster ? latest_s_ : clusters_[end].first_s - 1 / rule_.rate_hz - rule_.margin_s;
        if (to_s - from_s < std::max(rule_.margin_s, 2 / rule_.rate_hz)) return;
        WeighedExpectation one = weighed(spans);
        one.expectation.kind = WindowKind::during;
        one.lasts_s = to_s - from_s;
        if (one.lasts_s > (latest_s_ - first_s_) / 2) one.place = 0;  // what holds throughout is read once
        one.expectation.from_s = steps_.at_or_after(from_s);
        one.expectation.to_s = steps_.at_or_before(to_s);
        one.expectation.words = (begin == kNoCluster ? "The start" : time_words(from_s)) + std::string(" to ") +
                                (end == kNoCluster ? "the end: " : time_words(clusters_[end].first_s) + ": ") +
                                facts_words(one.expectation.facts, false) + ".";
        made_.push_back(std::move(one));
    }

    static WeighedExpectation weighed(const std::vector<const FactSpan*>& spans) {
        WeighedExpectation one;
        for (const FactSpan* const span : spans) {
            one.expectation.facts.push_back(span->fact);
            one.place = std::min(one.place, place_of(span->fact));
            one.lasts_s = std::max(one.lasts_s, span->last_s - span->first_s);
        }
        return one;
    }

    const RecordingRule& rule_;
    TimeSteps steps_;
    double first_s_, latest_s_;  // the latter before the last frame, so that no rounding leads beyond the input
    std::vector<FactSpan> spans_;
    std::vector<ChangeCluster> clusters_;
    std::vector<WeighedExpectation> made_;
};

/// "12 of effects (haze, silhouettes)"
std::string left_out_words(const std::vector<WeighedExpectation>& all, std::size_t from) {
    std::map<FactKind, std::pair<std::size_t, std::set<std::string>>> lost;
    for (std::size_t n = from; n < all.size(); ++n)
        for (const RecordedFact& fact : all[n].expectation.facts) {
            ++lost[fact.kind].first;
            lost[fact.kind].second.insert(fact.name.empty() ? fact.value : fact.name);
        }
    std::string words;
    for (const auto& [kind, counted] : lost) {
        words +=
            (words.empty() ? "" : "; ") + std::to_string(counted.first) + " of " + kKindWords[static_cast<std::size_t>(kind)];
        std::size_t n = 0;
        for (const std::string& name : counted.second)
            if (++n <= kNamesInWords) words += (n == 1 ? " (" : ", ") + name;
        words += n > kNamesInWords ? " and " + std::to_string(n - kNamesInWords) + " more)" : ")";
    }
    return words;
}

bool is_rather_kept(const WeighedExpectation& a, const WeighedExpectation& b) {
    return a.place != b.place ? a.place < b.place : a.lasts_s > b.lasts_s;
}

bool is_earlier(const RecordedExpectation& a, const RecordedExpectation& b) {
    return a.from_s != b.from_s ? a.from_s < b.from_s : a.to_s < b.to_s;
}

}  // namespace

RecordedExpectations expectations_of(const FactTracks& tracks, const RecordingRule& rule) {
    std::vector<WeighedExpectation> all = ExpectationMaker(tracks, rule).make();
    std::stable_sort(all.begin(), all.end(), is_rather_kept);
    RecordedExpectations kept;
    const std::size_t count = std::min(all.size(), rule.expectations);
    if (count < all.size()) kept.left_out = left_out_words(all, count);
    for (std::size_t n = 0; n < count; ++n) kept.list.push_back(std::move(all[n].expectation));
    std::stable_sort(kept.list.begin(), kept.list.end(), is_earlier);
    return kept;
}

RecordedExpectation expectation_at(double at_s, const std::vector<RecordedFact>& facts) {
    RecordedExpectation one;
    one.from_s = one.to_s = at_s;
    for (const RecordedFact& fact : facts)
        if (fact.value != "missing") one.facts.push_back(fact);
    one.words = "At " + time_words(at_s) + ".";
    return one;
}

}  // namespace tedavis::host_sim
