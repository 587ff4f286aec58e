#include "host_sim/reports/run_difference.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "host_sim/png_file.hpp"
#include "host_sim/reports/run_folder.hpp"
#include "host_sim/reports/run_records.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

using Json = nlohmann::ordered_json;

/// A run's records without what only the machine decides.
class ComparableRecords {
public:
    explicit ComparableRecords(const std::string& folder) : records_(folder) {}
    std::optional<Json> next() {
        std::optional<Json> record = records_.next();
        if (record) record->erase("ms");
        return record;
    }
    [[nodiscard]] std::uint64_t line() const { return records_.line(); }

private:
    RunRecords records_;
};

void collect(const Json& a, const Json& b, const std::string& place, std::vector<RecordDifference>& found) {
    if (a == b) return;
    if (a.is_object() && b.is_object()) {
        const auto under = [&](const std::string& key) { return place.empty() ? key : place + "." + key; };
        for (const auto& item : a.items()) {
            if (b.contains(item.key())) {
                collect(item.value(), b[item.key()], under(item.key()), found);
            } else {
                found.push_back({under(item.key()), item.value().dump(), ""});
            }
        }
        for (const auto& item : b.items()) {
            if (!a.contains(item.key())) found.push_back({under(item.key()), "", item.value().dump()});
        }
        return;
    }
    if (a.is_array() && b.is_array()) {
        for (std::size_t i = 0; i < std::max(a.size(), b.size()); ++i) {
            const std::string at = place + "[" + std::to_string(i) + "]";
            if (i >= a.size() || i >= b.size()) {
                found.push_back({at, i < a.size() ? a[i].dump() : "", i < b.size() ? b[i].dump() : ""});
            } else {
                collect(a[i], b[i], at, found);
            }
        }
        return;
    }
    found.push_back({place, a.dump(), b.dump()});
}

PixelDifference compare_pictures(const std::string& path_a, const std::string& path_b) {
    PixelDifference difference;
    if (!std::filesystem::exists(path_a) || !std::filesystem::exists(path_b)) {
        difference.note = "the pictures were not written by both runs";
        return difference;
    }
    const RgbaPicture a = read_png(path_a), b = read_png(path_b);
    if (a.width != b.width || a.height != b.height) {
        difference.note = "the pictures are " + std::to_string(a.width) + "x" + std::to_string(a.height) + " and " +
                          std::to_string(b.width) + "x" + std::to_string(b.height);
        return difference;
    }
    difference.left = a.width;
    difference.top = a.height;
    for (std::uint32_t y = 0; y < a.height; ++y) {
        for (std::uint32_t x = 0; x < a.width; ++x) {
            const std::size_t place = (std::size_t{y} * a.width + x) * 4;
            std::uint32_t largest = 0;
            for (std::size_t c = 0; c < 4; ++c)
                largest =
                    std::max(largest, static_cast<std::uint32_t>(std::abs(int{a.pixels[place + c]} - int{b.pixels[place + c]})));
            if (largest == 0) continue;
            ++difference.count;
            difference.largest = std::max(difference.largest, largest);
            difference.left = std::min(difference.left, x);
            difference.right = std::max(difference.right, x);
            difference.top = std::min(difference.top, y);
            difference.bottom = std::max(difference.bottom, y);
        }
    }
    if (difference.count == 0) {
        difference = {};
        difference.note = "the pictures on disk are equal although the recorded hashes differ";
    }
    return difference;
}

}  // namespace

std::optional<RunDifference> first_difference(const std::string& folder_a, const std::string& folder_b) {
    ComparableRecords reader_a(folder_a), reader_b(folder_b);
    for (;;) {
        const auto a = reader_a.next(), b = reader_b.next();
        if (!a && !b) return std::nullopt;
        if (a && b && *a == *b) continue;
        const Json& known = a ? *a : *b;
        RunDifference difference;
        difference.frame = known["frame"].get<std::uint64_t>();
        difference.time_s = known.contains("time_s") && known["time_s"].is_number() ? known["time_s"].get<double>() : 0.0;
        difference.line = std::max(reader_a.line(), reader_b.line());
        difference.a_ended = !a;
        difference.b_ended = !b;
        if (!a || !b) return difference;
        collect(*a, *b, "", difference.entries);
        if (difference.entries.empty()) continue;  // the same entries in another order
        if ((*a)["hash"] != (*b)["hash"]) {
            difference.pixels = compare_pictures(frame_picture_path(folder_a, difference.frame),
                                                 frame_picture_path(folder_b, (*b)["frame"].get<std::uint64_t>()));
        }
        return difference;
    }
}

}  // namespace tedavis::host_sim
