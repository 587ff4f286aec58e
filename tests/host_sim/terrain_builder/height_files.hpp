/// Height files of every format that GDAL can write, made from one raster of formulas.
#pragma once

#include <cpl_string.h>
#include <cpl_vsi.h>

#include <string>
#include <vector>

#include "tests/support/files/raster_file.hpp"

namespace tedavis::test_support {

/// Writes the raster in another format and returns the path. `options`: the driver's, as KEY=VALUE.
inline std::string write_as(
    const char* driver, const RasterFile& raster, const std::string& path, const std::vector<std::string>& options = {},
    const std::function<void(GDALDataset&)>& more = [](GDALDataset&) {}) {
    const std::string original = path + ".original.tif";
    raster.write(original);
    CPLStringList list;
    for (const std::string& option : options) list.AddString(option.c_str());
    {
        const std::unique_ptr<GDALDataset, GDALDatasetUniquePtrDeleter> from(GDALDataset::Open(original.c_str(), GDAL_OF_UPDATE));
        more(*from);
        const std::unique_ptr<GDALDataset, GDALDatasetUniquePtrDeleter> to(
            GetGDALDriverManager()->GetDriverByName(driver)->CreateCopy(path.c_str(), from.get(), FALSE, list.List(), nullptr,
                                                                        nullptr));
        EXPECT_NE(to, nullptr) << driver << ": " << CPLGetLastErrorMsg();
    }
    VSIUnlink(original.c_str());
    VSIUnlink((original + ".aux.xml").c_str());
    VSIUnlink((path + ".aux.xml").c_str());  // what the format itself does not hold
    return path;
}

/// Bytes at an offset of a file, replaced.
inline void patch_file(const std::string& path, std::size_t offset, const std::string& bytes) {
    VSILFILE* const file = VSIFOpenL(path.c_str(), "r+b");
    ASSERT_NE(file, nullptr);
    EXPECT_EQ(VSIFSeekL(file, offset, SEEK_SET), 0);
    EXPECT_EQ(VSIFWriteL(bytes.data(), 1, bytes.size(), file), bytes.size());
    VSIFCloseL(file);
}

}  // namespace tedavis::test_support
