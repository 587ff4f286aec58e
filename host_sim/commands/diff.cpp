#include "host_sim/commands/diff.hpp"

#include <nlohmann/json.hpp>

#include "host_sim/json_text.hpp"
#include "host_sim/reports/line_chart.hpp"
#include "host_sim/reports/run_difference.hpp"

namespace tedavis::host_sim {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kEntriesInText = 12;

Json difference_json(const RunDifference& difference) {
    Json json = {{"same", false},           {"frame", difference.frame},     {"time_s", difference.time_s},
                 {"line", difference.line}, {"a_ended", difference.a_ended}, {"b_ended", difference.b_ended}};
    Json entries = Json::array();
    for (const RecordDifference& entry : difference.entries) {
        entries.push_back({{"entry", entry.entry},
                           {"a", entry.a.empty() ? Json(nullptr) : Json::parse(entry.a)},
                           {"b", entry.b.empty() ? Json(nullptr) : Json::parse(entry.b)}});
    }
    json["entries"] = entries;
    json["pixels"] = nullptr;
    if (const auto& pixels = difference.pixels) {
        json["pixels"] = {{"count", pixels->count},
                          {"box", {pixels->left, pixels->top, pixels->right, pixels->bottom}},
                          {"largest", pixels->largest},
                          {"note", pixels->note}};
    }
    return json;
}

std::string pixel_text(const PixelDifference& pixels) {
    if (!pixels.note.empty()) return "\n  pixels: " + pixels.note;
    return "\n  pixels: " + std::to_string(pixels.count) + " differ, within x " + std::to_string(pixels.left) + ".." +
           std::to_string(pixels.right) + ", y " + std::to_string(pixels.top) + ".." + std::to_string(pixels.bottom) +
           " from the top left, by at most " + std::to_string(pixels.largest) + "/255";
}

std::string difference_text(const DiffOptions& options, const RunDifference& difference) {
    std::string text = "frame " + std::to_string(difference.frame) + " at " + decimal(difference.time_s, 3) + " s (line " +
                       std::to_string(difference.line) + ") ";
    if (difference.a_ended || difference.b_ended) {
        return text + "is missing from " + (difference.a_ended ? options.run_a : options.run_b) + ", which has fewer frames";
    }
    text += "is the first that differs";
    for (std::size_t i = 0; i < difference.entries.size() && i < kEntriesInText; ++i) {
        const RecordDifference& entry = difference.entries[i];
        text +=
            "\n  " + entry.entry + ": " + (entry.a.empty() ? "absent" : entry.a) + " / " + (entry.b.empty() ? "absent" : entry.b);
    }
    if (difference.entries.size() > kEntriesInText)
        text +=
            "\n  and " + std::to_string(difference.entries.size() - kEntriesInText) + " more entries (all of them with --json)";
    return difference.pixels ? text + pixel_text(*difference.pixels) : text;
}

}  // namespace

int run_diff(const DiffOptions& options, Console& console) {
    const auto difference = first_difference(options.run_a, options.run_b);
    if (!difference) {
        console.result("the runs are the same", json_text(Json{{"same", true}}));
        return 0;
    }
    console.result(difference_text(options, *difference), json_text(difference_json(*difference)));
    return 1;
}

}  // namespace tedavis::host_sim
