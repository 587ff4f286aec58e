/// Reports a traced picture, its times and its memory as text and JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "host_sim/tracing/chosen_shot.hpp"

namespace tedavis::host_sim {

/// "12.3 MB"
[[nodiscard]] std::string megabytes(std::uint64_t bytes);
/// "12.4", rounded up, as a number for --memory.
[[nodiscard]] std::string megabytes_up(std::uint64_t bytes);
/// "two triangles a cell, Lambert; 12.1 ms a picture (after 5.0 ms of preparing), 24.9 MB: heights 18.7, maximum mipmap 6.2"; of
/// paged ground it ends with "; paged: 41 chunks read (0.9 MB) of 49, 12 in memory at a time"
[[nodiscard]] std::string shot_line(const TracedGround& ground, const std::string& operators, const TracedShot& shot);
/// Keys that scripts may rely on: `operators`, `picture_ms`, `prepare_ms`, `bytes` {`heights`, one for each item, `all`}, `posts`
/// {`columns`, `rows`, `type`, `void`}, `kernel`, `workers`, `pieces`, `stream_rounds`, `ground_share`, `paged`. Where that is
/// true, `posts` has no `void`, and `paging` has `memory_bytes`, `held_bytes`, `read_bytes`, `chunks`, `slots`, `chunks_read`,
/// `passes`.
[[nodiscard]] nlohmann::ordered_json shot_json(const TracedGround& ground, const std::string& operators, const TracedShot& shot,
                                               std::uint32_t workers);
/// "chosen by region: 131 two triangles a cell, Lambert; ...; error 0.0101; 48.2 ms a picture (...)"
[[nodiscard]] std::string choice_line(const TracedGround& ground, const ChosenShot& chosen);
/// Keys that scripts may rely on: `deadline_ms`, `most_error` (where asked), `levels` [{`operators`, `picture_ms`, `error`}],
/// `frames` [{`picture_ms`, `expected_ms`, `error`, `regions`}].
[[nodiscard]] nlohmann::ordered_json choice_json(const ChosenShot& chosen, const ChoicePlan& plan);
[[nodiscard]] nlohmann::ordered_json pose_json(const AircraftPose& pose);

}  // namespace tedavis::host_sim
