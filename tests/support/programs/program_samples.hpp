/// Sound files of every kind that `tedavis` reads, each made when a test first asks for it, mostly by `tedavis` itself.
#pragma once

#include <string>

#include "tests/support/files/temporary_folder.hpp"

namespace tedavis::test_support {

class ProgramSamples {
public:
    /// The path of the built program.
    [[nodiscard]] static std::string program();
    /// flight.igc .gpx .json .csv .csv.gz, raster.tif, terrain.tdb, scenario.toml, design.toml, device.toml, aircraft.toml,
    /// panel.toml, bus.toml, sheet.toml, image.ppm, picture.png, gaze.csv, replay.toml, run.log, run.switches, frames.jsonl, and
    /// the folder `run` of a replay.
    [[nodiscard]] static std::string path(const std::string& name);
    [[nodiscard]] static std::string read(const std::string& name);

private:
    void make(const std::string& name) const;
    void make_with_program(const std::string& name) const;
    static const ProgramSamples& get();

    TemporaryFolder folder_;
};

}  // namespace tedavis::test_support
