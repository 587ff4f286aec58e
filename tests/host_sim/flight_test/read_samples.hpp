/// A table of a flight test, as its readers get it.
#pragma once

#include <string>
#include <vector>

#include "host_sim/flight_test/script_table.hpp"
#include "host_sim/input_file.hpp"
#include "host_sim/shipped_files.hpp"

namespace tedavis::test_support {

/// Reads text by `read(table, faults)`; what it found wrong lies in `sentences`.
template <class Read>
auto read_sample(const std::string& text, std::vector<std::string>& sentences, Read read) {
    host_sim::ScriptFaults faults;
    const host_sim::ScriptValue tree = host_sim::parse_script_value(text, "f.toml", faults);
    host_sim::ScriptTable table(tree, faults);
    auto result = read(table, faults);
    sentences = faults.sentences();
    return result;
}

}  // namespace tedavis::test_support
