/// The text of a flight test that was recorded, to be edited by hand.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "host_sim/flight_test/recorded_expectations.hpp"

namespace tedavis::host_sim {

struct RecordedScript {
    std::string title;
    std::vector<std::string> notes;  ///< sentences at its beginning
    using Named = std::pair<std::string, std::string>;
    std::vector<Named> settings;  ///< key and text; those with an empty text are left out
    std::vector<Named> input;     ///< keys and texts of [input], likewise
    std::vector<RecordedExpectation> expectations;
};

/// TOML that read_flight_test() reads.
[[nodiscard]] std::string recorded_script_text(const RecordedScript& script);

/// Returns the name of a file in a script in `folder`: relative to it where both share a folder below the root, else absolute.
[[nodiscard]] std::string path_in_script(const std::string& path, const std::string& folder);

}  // namespace tedavis::host_sim
