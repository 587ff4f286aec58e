#include "host_sim/comparison/comparison_words.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "host_sim/calendar_time.hpp"
#include "host_sim/comparison/height_words.hpp"
#include "host_sim/reports/line_chart.hpp"
#include "host_sim/reports/run_findings.hpp"
#include "render_core/base/units.hpp"

namespace tedavis::host_sim {
namespace {

/// Without the folders before it; of a folder its own name.
std::string last_part(const std::string& path) {
    std::filesystem::path trimmed(path);
    if (!trimmed.has_filename()) trimmed = trimmed.parent_path();
    return trimmed.filename().string();
}

std::string or_none(const std::string& name) { return name.empty() ? "none" : last_part(name); }

std::string in_feet(double metres) { return decimal(metres / base::kMetresPerFoot, 0) + " ft (" + decimal(metres, 0) + " m)"; }

std::string introduction(const ComparedRun& run, const char* letter) {
    std::string text = std::string(letter) + " is " + run.folder + ": " + counted(run.frames.size(), "frame");
    if (!run.log.empty()) text += " of " + last_part(run.log);
    const double begin_s = run.frames.front().time_s, end_s = run.frames.back().time_s;
    if (const auto offset_s = utc_offset_s(run))
        text += ", " + utc_text(base::Time{} + base::Duration::from_seconds(begin_s + *offset_s)).substr(0, 10);
    text += ", " + frame_time_words(run, begin_s) + " to " + frame_time_words(run, end_s);
    if (!run.design.empty()) text += ", with the design " + last_part(run.design);
    if (!run.device.empty()) text += " on the device " + last_part(run.device);
    return text + (run.size.empty() ? "." : ", " + run.size + ".");
}

/// In one unit, that of the greater one.
std::string distances_apart_words(double mean_m, double greatest_m) {
    const bool is_far = greatest_m >= 1000;
    const auto words = [&](double metres) { return is_far ? decimal(metres / 1000, 1) + " km" : decimal(metres, 0) + " m"; };
    return "; both places are " + words(mean_m) + " apart in the mean and " + words(greatest_m) + " at most";
}

/// "every frame", "every 3rd frame".
std::string every_words(std::size_t stride) {
    if (stride == 1) return "every frame";
    const std::size_t last = stride / 10 % 10 == 1 ? 0 : stride % 10;
    return "every " + std::to_string(stride) + (last == 1 ? "st" : last == 2 ? "nd" : last == 3 ? "rd" : "th") + " frame";
}

std::string thinned_sentence(const RunComparison& runs) {
    const std::size_t stride_a = runs.aligned.stride_a, stride_b = runs.aligned.stride_b;
    if (stride_a == 1 && stride_b == 1) return {};
    return "The runs are long, so that " + every_words(stride_a) + " of A and " + every_words(stride_b) + " of B was looked at. ";
}

/// Frames that do not meet make differences of their own, which the page must say.
std::string pairing_sentence(const RunComparison& runs) {
    constexpr double kTold_s = 0.05;
    double greatest_s = 0;
    for (const AlignedInstant& instant : runs.aligned.instants) {
        const std::size_t nearest = instant.nearest_b(),
                          other = instant.b < static_cast<double>(nearest) ? nearest - 1 : nearest + 1;
        const double share = std::abs(instant.b - static_cast<double>(nearest));
        if (share == 0 || other >= runs.b.frames.size()) continue;
        const double apart_s = std::abs(runs.b.frames[other].time_s - runs.b.frames[nearest].time_s);
        greatest_s = std::max(greatest_s, share * apart_s);
    }
    if (!(greatest_s >= kTold_s)) return {};
    return " The frames of B that are compared lie up to " + decimal(greatest_s, greatest_s < 10 ? 1 : 0) +
           " s from these moments: pictures, labels, effects, alerts and phases are those of the nearest frame, heights are "
           "interpolated "
           "between frames. Differences may come from that alone; runs with the same --from and --step have none.";
}

/// Where the frames of B are farther apart than those of A.
std::string repeated_sentence(const RunComparison& runs) {
    if (runs.compared_b.size() == runs.compared_a.size()) return {};
    return " They are " + counted(runs.compared_b.size(), "frame") +
           " of B, some of them for several frames of A; counts have each frame once.";
}

std::string alignment_sentence(const RunComparison& runs) {
    const auto& instants = runs.aligned.instants;
    double sum_m = 0, greatest_m = 0;
    std::size_t known = 0;
    for (const AlignedInstant& instant : instants) {
        if (!std::isfinite(instant.distance_m)) continue;
        sum_m += instant.distance_m;
        greatest_m = std::max(greatest_m, instant.distance_m);
        ++known;
    }
    std::string text = runs.aligned.words + ". " + thinned_sentence(runs) + "B has a counterpart to " +
                       part_of(instants.size(), runs.aligned.searched) + " frames of A";
    if (runs.aligned.stride_a > 1) text += " that were looked at";
    if (known > 0 && greatest_m >= 1) text += distances_apart_words(sum_m / static_cast<double>(known), greatest_m);
    return text + "." + repeated_sentence(runs) + pairing_sentence(runs);
}

/// Rounded values that are equal are no difference that is worth a sentence.
bool is_told(const QuantityDifference& one, double worth) { return std::abs(one.greatest) >= worth; }

std::string higher_sentence(const RunComparison& runs) {
    const QuantityDifference* const one = runs.find(kAltitude);
    if (one == nullptr || !is_told(*one, 1)) return {};
    const double mean_m = one->mean_b - one->mean_a;
    const std::string in_mean = std::abs(mean_m) < 1 ? std::string("B flew as high as A in the mean")
                                                     : "B flew " + in_feet(std::abs(mean_m)) +
                                                           (mean_m < 0 ? " lower" : " higher") + " than A in the mean";
    return in_mean + "; at most they were " + in_feet(std::abs(one->greatest)) + " apart, at " +
           instant_words(runs, one->greatest_at) + ".";
}

std::string both_searched_words(const RunClosest& a, const RunClosest& b) {
    if (searched_words(a) == searched_words(b)) return "each over " + searched_words(a);
    return "A over " + searched_words(a) + ", B over " + searched_words(b);
}

std::string ground_sentence(const RunComparison& runs) {
    if (!runs.closest_a || !runs.closest_b) return {};
    const RunClosest &a = *runs.closest_a, &b = *runs.closest_b;
    const double closer_m = a.height_m - b.height_m;
    if (std::abs(closer_m) < 1) {
        const QuantityDifference* const one = runs.find(kHeightAboveTerrain);
        if (one == nullptr || !is_told(*one, 1)) return {};
        return "Both came equally close to the ground in flight, to " + in_feet(a.height_m) + " above it; " +
               both_searched_words(a, b) + ".";
    }
    return std::string(closer_m > 0 ? "B" : "A") + " came " + in_feet(std::abs(closer_m)) +
           " closer to the ground in flight: A to " + in_feet(a.height_m) + " above it at " + frame_time_words(runs.a, a.time_s) +
           ", B to " + in_feet(b.height_m) + " at " + frame_time_words(runs.b, b.time_s) + "; " + both_searched_words(a, b) + ".";
}

/// Sums over unequally many frames say nothing.
std::string count_per_frame_sentence(const QuantityDifference& one, const char* done, const char* what) {
    const std::string means = decimal(one.mean_b, 1) + " in " + counted(one.values_b, "frame") + " of B, " +
                              decimal(one.mean_a, 1) + " in " + counted(one.values_a, "frame") + " of A.";
    const std::string more = decimal(std::abs(one.mean_b - one.mean_a), 1);
    if (more == "0.0") return std::string("A and B ") + done + " equally many " + what + "s per frame in the mean: " + means;
    return std::string("B ") + done + " " + more + " " + what + "s " + (one.mean_b > one.mean_a ? "more" : "fewer") +
           " per frame in the mean: " + means;
}

std::string count_sentence(const RunComparison& runs, std::size_t quantity, const char* done, const char* what) {
    const QuantityDifference* const one = runs.find(quantity);
    if (one == nullptr || one->greatest == 0) return {};
    if (one->values_a != one->values_b) return count_per_frame_sentence(*one, done, what);
    const auto sum_a = std::llround(one->sum_a()), sum_b = std::llround(one->sum_b()), more = std::abs(sum_b - sum_a);
    const std::string in_all = std::to_string(sum_b) + " against " + std::to_string(sum_a) + " in " +
                               counted(one->values_a, "frame") + (one->values_a == 1 ? "" : " of each");
    if (more == 0)
        return std::string("A and B ") + done + " equally many " + what + "s in all, but not in each frame: " + in_all + ".";
    return std::string("B ") + done + " " + counted(static_cast<std::uint64_t>(more), what) +
           (sum_b > sum_a ? " more: " : " fewer: ") + in_all + ".";
}

std::string effects_sentence(const RunComparison& runs) {
    constexpr std::size_t kNamed = 4;
    std::string text;
    std::size_t told = 0, differing = 0;
    for (const EffectDifference& effect : runs.effects) {
        if (effect.share_a == effect.share_b) continue;
        ++differing;
        if (told == kNamed) continue;
        text += (told++ == 0 ? "" : ", ") + effect.name + " (A " + std::to_string(effect.frames_a) + ", B " +
                std::to_string(effect.frames_b) + ")";
    }
    if (differing == 0) return {};
    const std::string frames = std::to_string(runs.compared_a.size());
    const std::string of_frames =
        runs.compared_a.size() == runs.compared_b.size()
            ? "unequally many of " + frames + " frames"
            : "unequal parts of the frames, " + frames + " of A and " + std::to_string(runs.compared_b.size()) + " of B";
    return counted(differing, "effect") + (differing == 1 ? " was" : " were") + " drawn in " + of_frames +
           (differing > kNamed ? ", most of all " : ": ") + text + ".";
}

std::string levels_words(const AlertLevels& levels) {
    return "caution in " + std::to_string(levels[1]) + " and warning in " + std::to_string(levels[2]) + " of " +
           std::to_string(levels[0] + levels[1] + levels[2]);
}

std::string alert_sentence(const char* what, const AlertLevels& a, const AlertLevels& b) {
    if (a[1] + a[2] + b[1] + b[2] == 0) return {};
    const std::string kind = std::string(what) + " alerts";
    if (a == b) return "Both showed " + kind + " in equally many frames: " + levels_words(a) + ".";
    return "Frames with " + kind + ": " + levels_words(a) + " in A, " + levels_words(b) + " in B.";
}

std::string time_sentence(const RunComparison& runs) {
    const QuantityDifference* const one = runs.find(kFrameTime);
    if (one == nullptr || one->greatest == 0) return {};
    return "A frame took " + decimal(one->median_a, 1) + " ms in A and " + decimal(one->median_b, 1) +
           " ms in B (medians, on the machine that drew each).";
}

std::string phase_sentence(const RunComparison& runs) {
    if (runs.other_phase == 0) return {};
    const std::size_t first = *runs.first_other_phase;
    return "The flight phase differs in " + part_of(runs.other_phase, runs.aligned.instants.size()) + " instants, first at " +
           instant_words(runs, first) + ": " + runs.frame_a(first).phase + " in A, " + runs.frame_b(first).phase + " in B.";
}

std::string title_within(std::size_t quantity) {
    std::string title = kQuantities[quantity].title;
    title[0] = static_cast<char>(title[0] - 'A' + 'a');
    return title;
}

void add_listed(std::string& list, const std::string& name) { list += (list.empty() ? "" : ", ") + name; }

bool is_known_in_all(const RunComparison& runs, const QuantityDifference& one) {
    return one.count == runs.aligned.instants.size();
}

bool has_all_phases(const RunComparison& runs) {
    for (std::size_t n = 0; n < runs.aligned.instants.size(); ++n)
        if (!knows_phase(runs.frame_a(n)) || !knows_phase(runs.frame_b(n))) return false;
    return true;
}

std::string equal_sentence(const RunComparison& runs) {
    std::string equal;
    for (const QuantityDifference& one : runs.quantities)
        if (one.greatest == 0 && is_known_in_all(runs, one)) add_listed(equal, title_within(one.quantity));
    if (runs.other_phase == 0 && has_all_phases(runs)) add_listed(equal, "flight phase");
    return equal.empty() ? equal : "Equal in all instants: " + equal + ".";
}

std::string equal_where_known_sentence(const RunComparison& runs) {
    std::string equal;
    for (const QuantityDifference& one : runs.quantities)
        if (one.greatest == 0 && !is_known_in_all(runs, one))
            add_listed(equal, title_within(one.quantity) + " (" + part_of(one.count, runs.aligned.instants.size()) + ")");
    return equal.empty() ? equal : "Equal where both know it, in instants: " + equal + ".";
}

std::string known_by_one_sentence(const RunComparison& runs) {
    std::string alone;
    for (std::size_t quantity = 0; quantity < kQuantityCount; ++quantity)
        if (const std::size_t count = runs.known_by_one[quantity]; count > 0)
            add_listed(alone, title_within(quantity) + " (" + part_of(count, runs.aligned.instants.size()) + ")");
    return alone.empty() ? alone : "Known in one run alone, in instants: " + alone + ".";
}

std::string picture_sentence(const RunComparison& runs) {
    if (runs.equal_pictures == 0) return {};
    const bool are_all_known = runs.known_pictures == runs.aligned.instants.size();
    return "The pictures are equal in " + part_of(runs.equal_pictures, runs.known_pictures) + " instants" +
           (are_all_known ? "." : " in which both records have their hash.");
}

std::string nothing_differs_sentence(const RunComparison& runs) {
    const std::size_t instants = runs.aligned.instants.size();
    const bool is_pictured = runs.known_pictures == instants, has_phases = has_all_phases(runs);
    std::string text = std::string("Nothing differs") + (is_pictured && has_phases ? ": " : " in what is known: ") +
                       (is_pictured ? "pictures, " : "") + (has_phases ? "phases, " : "") +
                       "alerts, effects and all numbers that are not measured times are equal in " + counted(instants, "instant");
    if (is_pictured) return text + ".";
    return text + ", and the pictures " +
           (runs.known_pictures == 0 ? "of none are known."
                                     : "in the " + std::to_string(runs.known_pictures) + " that have them.");
}

/// Empty where all records have the hashes of their pictures.
std::string unknown_pictures_warning(const ComparedRun& run) {
    const auto known = static_cast<std::size_t>(std::count_if(run.frames.begin(), run.frames.end(), knows_picture));
    if (known == run.frames.size()) return {};
    return run.folder + " has no hash of the picture in " + part_of(run.frames.size() - known, run.frames.size()) +
           " records, as with --frames none, so that it is not known whether these pictures are equal; replay it with --frames "
           "hash "
           "or png";
}

std::string settings_words(const RunComparison& runs) {
    std::string text;
    for (const RunComparison::Setting& one : runs.settings) {
        const bool is_told_apart = or_none(one.a) != or_none(one.b);
        text += (text.empty() ? "" : "; ") + one.name + " " + (is_told_apart ? or_none(one.a) : one.a) + " in A, " +
                (is_told_apart ? or_none(one.b) : one.b) + " in B";
    }
    return text;
}

bool has_pictures(const ComparedRun& run) {
    return std::any_of(run.frames.begin(), run.frames.end(), [](const ComparedFrame& frame) { return !frame.picture.empty(); });
}

/// What the runs of one flight differ in: the design where that is it, else the first setting that does.
std::string same_flight_title(const RunComparison& runs) {
    if (runs.settings.empty()) return "Two runs of the same flight";
    const RunComparison::Setting& first = runs.settings.front();
    const std::string names = ": A " + or_none(first.a) + ", B " + or_none(first.b);
    if (first.name == "design") return "The same flight with two designs" + names;
    return "Two runs of the same flight, with another " + first.name + names;
}

}  // namespace

std::string instant_words(const RunComparison& runs, std::size_t instant) {
    const std::string a = frame_time_words(runs.a, runs.frame_a(instant).time_s);
    const std::string b = frame_time_words(runs.b, runs.frame_b(instant).time_s);
    return a == b ? a : "A " + a + ", B " + b;
}

std::string comparison_title(const RunComparison& runs) {
    if (is_same_flight(runs.a, runs.b)) return same_flight_title(runs);
    const std::string log_a = last_part(runs.a.log), log_b = last_part(runs.b.log);
    const bool is_by_log = !log_a.empty() && !log_b.empty() && log_a != log_b;
    return "Two flights: A " + (is_by_log ? log_a : last_part(runs.a.folder)) + ", B " +
           (is_by_log ? log_b : last_part(runs.b.folder));
}

std::vector<std::string> run_introductions(const RunComparison& runs) {
    std::vector<std::string> sentences = {introduction(runs.a, "A"), introduction(runs.b, "B"), alignment_sentence(runs)};
    if (!runs.settings.empty()) sentences.push_back("They differ in this: " + settings_words(runs) + ".");
    return sentences;
}

std::vector<std::string> difference_sentences(const RunComparison& runs) {
    std::vector<std::string> sentences;
    const auto tell = [&](const std::string& sentence) {
        if (!sentence.empty()) sentences.push_back(sentence);
    };
    const auto tell_all = [&](const std::vector<std::string>& more) {
        sentences.insert(sentences.end(), more.begin(), more.end());
    };
    if (runs.is_equal()) {
        tell(nothing_differs_sentence(runs));
        tell(ground_sentence(runs));
        tell_all(height_sentences(runs));
        tell(time_sentence(runs));
        return sentences;
    }
    tell(ground_sentence(runs));
    tell(higher_sentence(runs));
    tell_all(height_sentences(runs));
    tell(alert_sentence("terrain", runs.terrain_a, runs.terrain_b));
    tell(alert_sentence("obstacle", runs.obstacles_a, runs.obstacles_b));
    tell(count_sentence(runs, kLabelsPlaced, "placed", "label"));
    tell(count_sentence(runs, kDataDrawn, "drew", "data feature"));
    tell(count_sentence(runs, kCrowdedRegions, "had", "crowded region"));
    tell(effects_sentence(runs));
    tell(phase_sentence(runs));
    tell(time_sentence(runs));
    tell(picture_sentence(runs));
    tell(equal_sentence(runs));
    tell(equal_where_known_sentence(runs));
    tell(known_by_one_sentence(runs));
    return sentences;
}

std::vector<std::string> comparison_warnings(const RunComparison& runs) {
    std::vector<std::string> sentences;
    const auto is_unlike = [](const std::string& a, const std::string& b) { return !a.empty() && !b.empty() && a != b; };
    if (is_unlike(runs.a.size, runs.b.size))
        sentences.push_back("the pictures of " + runs.a.folder + " are " + runs.a.size + " and those of " + runs.b.folder + " " +
                            runs.b.size + "; labels, data and times are counted in pictures of different size");
    for (const ComparedRun* run : {&runs.a, &runs.b}) {
        if (const std::string warning = unknown_pictures_warning(*run); !warning.empty()) sentences.push_back(warning);
        if (!has_pictures(*run))
            sentences.push_back(run->folder + " has no pictures, so that none stand side by side; replay it with --frames png");
    }
    return sentences;
}

}  // namespace tedavis::host_sim
