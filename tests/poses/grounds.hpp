/// The terrains that the long proofs go over: the shipped one, and real ones where they are at hand.
#pragma once

#include <cstdint>
#include <filesystem>
#include <ostream>
#include <string>
#include <vector>

#include "tests/support/files/paths.hpp"

namespace tedavis {

struct Ground {
    const char* name;
    std::string file;
    std::uint32_t pictures;  ///< poses to draw: the whole raster is projected for each without void ground
};
inline void PrintTo(const Ground& ground, std::ostream* out) { *out << ground.name; }

inline std::vector<Ground> grounds() {
    const std::string folder = test_support::real_data_dir() + "/terrain/";
    std::vector<Ground> all{{"default", test_support::source_dir() + "/configs/data/jacksboro_srtm3.tif", 320}};
    for (const Ground& real : {Ground{"davos", folder + "davos_engadin_srtm1_1arcsec_2160x2160_wgs84.tif", 48},
                               Ground{"pyrenees_with_voids", folder + "N42E001_pyrenees_andorra_srtm3.hgt.zip", 320}})
        if (std::filesystem::exists(real.file)) all.push_back(real);
    return all;
}

}  // namespace tedavis
