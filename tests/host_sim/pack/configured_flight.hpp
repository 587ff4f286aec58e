/// A short flight, and a board's configuration that shows it: what packs are made of in tests.
#pragma once

#include <string>

#include "tests/support/files/paths.hpp"
#include "tests/support/flights/flown_circle.hpp"

namespace tedavis::host_sim {

struct ConfiguredFlight {
    test_support::FlownFiles files;
    std::string configs = test_support::source_dir() + "/configs/";
    std::string config = write();

    /// `tables` may add sections; `design` is that of the file.
    [[nodiscard]] std::string write(const std::string& tables = "", const std::string& design = "") const {
        const std::string shown = design.empty() ? configs + "designs/approach.toml" : design;
        return files.folder.write("board.toml", "title = 'a board'\ndevice = '" + configs +
                                                    "devices/es2-small.toml'\ndesign = '" + shown + "'\npalettes = '" + configs +
                                                    "palettes'\nbus = '" + configs + "buses/canaerospace.toml'\naircraft = '" +
                                                    configs +
                                                    "aircraft/jet.toml'\n[terrain]\ndatabase = 'terrain.tdb'\n[can]\ninterface = "
                                                    "'can9'\n[switches]\nconfig = '" +
                                                    configs + "switches/one_hot.toml'\n[memory]\ntouch = false\n" + tables);
    }
};

}  // namespace tedavis::host_sim
