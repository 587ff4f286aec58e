/// Finds the first difference of two runs from their folders.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace tedavis::host_sim {

struct RecordDifference {
    std::string entry;  ///< "terrain.triangles", "effects[2].state"
    std::string a, b;   ///< as JSON; empty where a run lacks the entry
};

struct PixelDifference {
    std::uint64_t count = 0;
    std::uint32_t left = 0, top = 0, right = 0, bottom = 0;  ///< both edges included
    std::uint32_t largest = 0;                               ///< of any channel, 1..255
    std::string note;                                        ///< why no pixels could be compared, else empty
};

struct RunDifference {
    std::uint64_t frame = 0;
    double time_s = 0;
    std::uint64_t line = 0;                 ///< of frames.jsonl, from 1
    std::vector<RecordDifference> entries;  ///< empty when one run simply has more frames
    bool a_ended = false, b_ended = false;
    std::optional<PixelDifference> pixels;  ///< where the hashes differ
};

/// Compares the records line by line; ignores `ms`. Returns nothing where all are equal. Throws UserError for a folder without
/// valid records.
[[nodiscard]] std::optional<RunDifference> first_difference(const std::string& folder_a, const std::string& folder_b);

}  // namespace tedavis::host_sim
