#include "host_sim/terrain_builder/image_source.hpp"

#include <cpl_vsi.h>

#include <algorithm>
#include <cmath>

#include "host_sim/quiet_gdal.hpp"
#include "host_sim/terrain_builder/raster_source.hpp"
#include "host_sim/terrain_builder/vertical_reference.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

constexpr std::size_t kPixelBytes = 4;

GdalDataset opened(const std::string& file) {
    GDALAllRegister();  // does nothing the second time
    CPLErrorReset();
    GdalDataset dataset(GDALDataset::Open(file.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY));
    if (dataset != nullptr && dataset->GetRasterCount() > 0) return dataset;
    const std::string reason = QuietGdal::last_message();
    VSIStatBufL info;
    if (VSIStatL(file.c_str(), &info) != 0) throw UserError(file + ": no such file; check the name");
    throw UserError(file + ": not an image that GDAL can read (" + reason + "); give a raster such as GeoTIFF, PNG or JPEG");
}

std::vector<std::array<std::uint8_t, 4>> palette_of(GDALRasterBand& band) {
    const GDALColorTable* const table = band.GetColorTable();
    std::vector<std::array<std::uint8_t, 4>> palette;
    if (table == nullptr || band.GetColorInterpretation() != GCI_PaletteIndex) return palette;
    palette.resize(256);  // entries that the file lacks are transparent
    for (int n = 0; n < std::min(table->GetColorEntryCount(), 256); ++n) {
        GDALColorEntry rgb;
        table->GetColorEntryAsRGB(n, &rgb);
        const auto byte = [](short value) { return static_cast<std::uint8_t>(std::clamp<short>(value, 0, 255)); };
        palette[static_cast<std::size_t>(n)] = {byte(rgb.c1), byte(rgb.c2), byte(rgb.c3), byte(rgb.c4)};
    }
    return palette;
}

}  // namespace

ImageSource::ImageSource(const DrapeOptions& options) : file_(options.file) {
    const QuietGdal quiet;
    dataset_ = opened(file_);
    columns_ = dataset_->GetRasterXSize();
    rows_ = dataset_->GetRasterYSize();
    find_bands();
    find_place(options);
    find_crs(options);
}

/// By what the bands say they are; bands that say nothing are grey, grey and alpha, RGB or RGBA by their number.
void ImageSource::find_bands() {
    const int count = dataset_->GetRasterCount();
    std::array<int, 3> named{};
    for (int n = 1; n <= count; ++n) {
        const GDALColorInterp meaning = dataset_->GetRasterBand(n)->GetColorInterpretation();
        if (meaning >= GCI_RedBand && meaning <= GCI_BlueBand) named[static_cast<std::size_t>(meaning - GCI_RedBand)] = n;
        if (meaning == GCI_AlphaBand && alpha_band_ == 0) alpha_band_ = n;
        if (meaning == GCI_CyanBand || meaning == GCI_HueBand)
            throw UserError(file_ + ": its bands are no red, green and blue; convert it to RGB and give that file");
    }
    const int colors = count - (alpha_band_ != 0 ? 1 : 0);
    if (named[0] != 0 && named[1] != 0 && named[2] != 0)
        color_bands_ = named;
    else if (colors >= 3)
        color_bands_ = {1, 2, 3};
    else
        color_bands_ = {1, 1, 1};
    for (const int band : {color_bands_[0], color_bands_[1], color_bands_[2], std::max(alpha_band_, 1)})
        if (dataset_->GetRasterBand(band)->GetRasterDataType() != GDT_Byte)
            throw UserError(file_ + ": its values are no 8-bit colours (" +
                            GDALGetDataTypeName(dataset_->GetRasterBand(band)->GetRasterDataType()) +
                            "); convert it with gdal_translate -ot Byte -scale and give that file");
    if (colors < 3) palette_ = palette_of(*dataset_->GetRasterBand(1));
    for (std::size_t n = 0; n < 3; ++n) {
        int has = 0;
        const double value = dataset_->GetRasterBand(color_bands_[n])->GetNoDataValue(&has);
        if (has != 0) no_data_[n] = value;
    }
}

void ImageSource::find_place(const DrapeOptions& options) {
    std::array<double, 6> t{};
    const bool stated = dataset_->GetGeoTransform(t.data()) == CE_None &&
                        std::all_of(t.begin(), t.end(), [](double x) { return std::isfinite(x); }) &&
                        t[1] * t[5] - t[2] * t[4] != 0;
    if (stated && options.extent)
        throw UserError("--drape-extent: " + file_ + " says itself where it lies; leave the option out");
    if (!stated && !options.extent)
        throw UserError(file_ +
                        ": the image does not say where on Earth it lies; give its outer edges with --drape-extent W,S,E,N, in "
                        "degrees or in units of the system named with --drape-crs");
    placed_by_options_ = !stated;
    if (placed_by_options_) {
        const MapExtent& e = *options.extent;
        t = {e.west, (e.east - e.west) / columns_, 0, e.north, 0, (e.south - e.north) / rows_};
    }
    transform_ = t;
    if (GDALInvGeoTransform(transform_.data(), to_pixels_.data()) == 0)
        throw UserError(file_ + ": the place that it states cannot be used; georeference it anew");
}

void ImageSource::find_crs(const DrapeOptions& options) {
    OGRSpatialReference crs;
    const OGRSpatialReference* const stated = dataset_->GetSpatialRef();
    if (options.crs) {
        if (crs.SetFromUserInput(options.crs->c_str()) != OGRERR_NONE)
            throw UserError("--drape-crs " + *options.crs + ": unknown coordinate system; use for instance EPSG:2056");
    } else if (placed_by_options_) {
        crs = wgs84_longitude_latitude();
    } else if (stated == nullptr || stated->IsEmpty() != 0 || stated->IsLocal() != 0) {
        throw UserError(file_ +
                        ": the image names no coordinate system on Earth; give it with --drape-crs, for instance --drape-crs "
                        "EPSG:4326");
    } else {
        crs = *stated;
    }
    crs_ = horizontal_part(crs);
    crs_.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
}

void ImageSource::read(int column, int row, int columns, int rows, std::uint8_t* rgba) const {
    const QuietGdal quiet;
    const bool whole = read_colors(column, row, columns, rows, rgba) && read_coverage(column, row, columns, rows, rgba);
    if (!whole || CPLGetLastErrorType() >= CE_Failure)
        throw UserError(file_ + ": the image ends early or is damaged (" + QuietGdal::last_message() + "); get a whole copy");
}

bool ImageSource::read_colors(int column, int row, int columns, int rows, std::uint8_t* rgba) const {
    std::array<int, 3> bands = color_bands_;
    const GSpacing line = static_cast<GSpacing>(kPixelBytes) * columns;
    return dataset_->RasterIO(GF_Read, column, row, columns, rows, rgba, columns, rows, GDT_Byte, 3, bands.data(), kPixelBytes,
                              line, 1) == CE_None;
}

/// Alpha, and colours of palettes.
bool ImageSource::read_coverage(int column, int row, int columns, int rows, std::uint8_t* rgba) const {
    const std::size_t pixels = static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
    GDALRasterBand* const first = dataset_->GetRasterBand(color_bands_[0]);
    const int flags = first->GetMaskFlags();
    const bool by_color = no_data_[0] && no_data_[1] && no_data_[2];
    GDALRasterBand* mask = alpha_band_ != 0 ? dataset_->GetRasterBand(alpha_band_) : nullptr;
    if (mask == nullptr && (flags & GMF_PER_DATASET) != 0) mask = first->GetMaskBand();
    const GSpacing line = static_cast<GSpacing>(kPixelBytes) * columns;
    if (mask != nullptr && mask->RasterIO(GF_Read, column, row, columns, rows, rgba + 3, columns, rows, GDT_Byte, kPixelBytes,
                                          line, nullptr) != CE_None)
        return false;
    for (std::size_t n = 0; n < pixels; ++n) {
        std::uint8_t* const p = rgba + kPixelBytes * n;
        if (mask == nullptr) p[3] = 255;
        // A pixel lacks data where all its colours say so: one black band makes no hole.
        if (by_color && p[0] == *no_data_[0] && p[1] == *no_data_[1] && p[2] == *no_data_[2]) p[3] = 0;
    }
    if (!palette_.empty()) apply_palette(pixels, rgba);
    return true;
}

void ImageSource::apply_palette(std::size_t pixels, std::uint8_t* rgba) const {
    for (std::size_t n = 0; n < pixels; ++n) {
        std::uint8_t* const p = rgba + kPixelBytes * n;
        const std::array<std::uint8_t, 4>& entry = palette_[p[0]];
        std::copy_n(entry.begin(), 3, p);
        p[3] = std::min(p[3], entry[3]);
    }
}

}  // namespace tedavis::host_sim
