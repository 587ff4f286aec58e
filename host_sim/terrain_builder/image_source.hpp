/// One image file opened with GDAL: the position of its pixels, and which of its bands are colours.
#pragma once

#include <ogr_spatialref.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "host_sim/terrain_builder/raster_file.hpp"
#include "host_sim/terrain_builder/raster_options.hpp"

namespace tedavis::host_sim {

/// The image with which a terrain is draped, and the user's statements about it.
struct DrapeOptions {
    std::string file;
    std::optional<std::string> crs;   ///< overrides the file's own
    std::optional<MapExtent> extent;  ///< outer edges of a file that is not georeferenced; degrees without `crs`
};

class ImageSource {
public:
    /// Throws UserError for a file that is no raster, is not georeferenced, has no or an unknown coordinate system, or has bands
    /// that are no 8-bit colours, grey values or palette entries.
    explicit ImageSource(const DrapeOptions& options);

    [[nodiscard]] const std::string& file() const { return file_; }
    [[nodiscard]] int columns() const { return columns_; }
    [[nodiscard]] int rows() const { return rows_; }
    [[nodiscard]] const OGRSpatialReference& crs() const { return crs_; }  ///< horizontal; longitude or easting first
    /// GDAL's transform from coordinates of `crs` to columns and rows, with whole numbers at the corners of pixels.
    [[nodiscard]] const std::array<double, 6>& to_pixels() const { return to_pixels_; }
    [[nodiscard]] const std::array<double, 6>& transform() const { return transform_; }

    /// Reads RGBA, not premultiplied, row by row, of pixels inside the image; alpha is 0 where mask, alpha band or nodata value
    /// mark missing pixels. One thread at a time. Throws UserError where the file is damaged.
    void read(int column, int row, int columns, int rows, std::uint8_t* rgba) const;

private:
    void find_bands();
    void find_place(const DrapeOptions& options);
    void find_crs(const DrapeOptions& options);
    [[nodiscard]] bool read_colors(int column, int row, int columns, int rows, std::uint8_t* rgba) const;
    [[nodiscard]] bool read_coverage(int column, int row, int columns, int rows, std::uint8_t* rgba) const;
    void apply_palette(std::size_t pixels, std::uint8_t* rgba) const;

    std::string file_;
    GdalDataset dataset_;
    int columns_ = 0, rows_ = 0;
    OGRSpatialReference crs_;
    std::array<double, 6> transform_{}, to_pixels_{};
    std::array<int, 3> color_bands_{};  ///< the same three times where the image is grey or has a palette
    int alpha_band_ = 0;                ///< 0: none
    std::vector<std::array<std::uint8_t, 4>> palette_;
    std::array<std::optional<double>, 3> no_data_;
    bool placed_by_options_ = false;
};

}  // namespace tedavis::host_sim
