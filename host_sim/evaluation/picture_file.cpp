#include "host_sim/evaluation/picture_file.hpp"

#include <cpl_conv.h>
#include <gdal_priv.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <memory>

#include "host_sim/input_file.hpp"
#include "host_sim/quiet_gdal.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

constexpr int kLargestSide = 32768;
constexpr std::string_view kPngSignature = "\x89PNG";
constexpr std::array<const char*, 6> kPictureDrivers = {"JPEG", "GTiff", "BMP", "GIF", "WEBP", nullptr};

struct CloseDataset {
    void operator()(GDALDataset* dataset) const { GDALClose(dataset); }
};
using PictureDataset = std::unique_ptr<GDALDataset, CloseDataset>;

/// Within its life, libjpeg's warnings are faults: a file that breaks off is not half a picture.
class StrictJpeg {
public:
    StrictJpeg() { CPLSetThreadLocalConfigOption("GDAL_ERROR_ON_LIBJPEG_WARNING", "TRUE"); }
    ~StrictJpeg() { CPLSetThreadLocalConfigOption("GDAL_ERROR_ON_LIBJPEG_WARNING", nullptr); }
    StrictJpeg(const StrictJpeg&) = delete;
    StrictJpeg& operator=(const StrictJpeg&) = delete;
};

std::string first_bytes(const std::string& path, std::size_t count) {
    require_regular_file(path);
    std::string bytes(count, '\0');
    std::ifstream stream(path, std::ios::binary);
    if (!stream) throw UserError(path + ": cannot be opened; check its permissions");
    stream.read(bytes.data(), static_cast<std::streamsize>(count));
    bytes.resize(static_cast<std::size_t>(stream.gcount()));
    return bytes;
}

PictureDataset opened_picture(const std::string& path) {
    GDALAllRegister();  // does nothing the second time
    static const std::array<const char*, 1> no_neighbours = {nullptr};
    CPLErrorReset();
    PictureDataset dataset(static_cast<GDALDataset*>(
        GDALOpenEx(path.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY, kPictureDrivers.data(), nullptr, no_neighbours.data())));
    if (dataset == nullptr || dataset->GetRasterCount() == 0)
        throw UserError(path + ": not a picture that can be read; give a PNG or a JPEG");
    if (dataset->GetRasterXSize() > kLargestSide || dataset->GetRasterYSize() > kLargestSide)
        throw UserError(path + ": larger than 32768 pixels a side; scale it down");
    return dataset;
}

struct PictureBands {
    std::array<int, 3> colors{1, 1, 1};  ///< the same three times where the picture is grey or has a palette
    int alpha = 0;                       ///< 0: none
};

/// One is grey, two are grey and alpha, three are colours, four colours and alpha.
PictureBands bands_of(GDALDataset& dataset, const std::string& path) {
    const int count = dataset.GetRasterCount();
    PictureBands bands;
    if (count >= 3) bands.colors = {1, 2, 3};
    if (count == 2 || count == 4) bands.alpha = count;
    for (int n = 1; n <= std::min(count, 4); ++n) {
        const GDALDataType type = dataset.GetRasterBand(n)->GetRasterDataType();
        if (type != GDT_Byte && type != GDT_UInt16)
            throw UserError(path + ": its values are no colours of 8 or 16 bits (" + GDALGetDataTypeName(type) +
                            "); save it as PNG or JPEG");
    }
    return bands;
}

/// One band into every fourth byte.
void read_band(GDALDataset& dataset, int number, std::uint8_t* first, const std::string& path) {
    GDALRasterBand& band = *dataset.GetRasterBand(number);
    const int width = dataset.GetRasterXSize(), height = dataset.GetRasterYSize();
    const auto read = [&](void* to, GDALDataType type, GSpacing pixel) {
        if (band.RasterIO(GF_Read, 0, 0, width, height, to, width, height, type, pixel, pixel * width, nullptr) != CE_None)
            throw UserError(path + ": damaged or cut short (" + QuietGdal::last_message() + "); save it again");
    };
    if (band.GetRasterDataType() == GDT_Byte) return read(first, GDT_Byte, 4);
    std::vector<std::uint16_t> wide(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    read(wide.data(), GDT_UInt16, 2);
    for (std::size_t n = 0; n < wide.size(); ++n) first[4 * n] = static_cast<std::uint8_t>((wide[n] + 128u) / 257u);
}

void apply_color_table(const GDALColorTable& table, RgbaPicture& picture) {
    for (std::size_t at = 0; at < picture.pixels.size(); at += 4) {
        GDALColorEntry entry{0, 0, 0, 0};
        if (picture.pixels[at] < table.GetColorEntryCount()) table.GetColorEntryAsRGB(picture.pixels[at], &entry);
        const std::array<short, 4> parts = {entry.c1, entry.c2, entry.c3, entry.c4};
        for (std::size_t c = 0; c < 4; ++c)
            picture.pixels[at + c] = static_cast<std::uint8_t>(std::clamp<short>(parts[c], 0, 255));
    }
}

RgbaPicture read_with_gdal(const std::string& path) {
    const QuietGdal quiet;
    const StrictJpeg strict;
    const PictureDataset dataset = opened_picture(path);
    const PictureBands bands = bands_of(*dataset, path);
    RgbaPicture picture{
        static_cast<std::uint32_t>(dataset->GetRasterXSize()), static_cast<std::uint32_t>(dataset->GetRasterYSize()), {}};
    picture.pixels.assign(std::size_t{picture.width} * picture.height * 4, 255);
    for (std::size_t c = 0; c < 3; ++c) read_band(*dataset, bands.colors[c], &picture.pixels[c], path);
    if (bands.alpha != 0) read_band(*dataset, bands.alpha, &picture.pixels[3], path);
    const GDALColorTable* const table = dataset->GetRasterBand(1)->GetColorTable();
    if (table != nullptr && bands.colors[1] == 1) apply_color_table(*table, picture);
    return picture;
}

bool is_opaque(const RgbaPicture& picture) {
    std::uint8_t all = 255;
    for (std::size_t at = 3; at < picture.pixels.size(); at += 4) all &= picture.pixels[at];
    return all == 255;
}

void lay_on_black(RgbaPicture& picture) {
    if (is_opaque(picture)) return;
    for (std::size_t at = 0; at < picture.pixels.size(); at += 4) {
        const std::uint32_t alpha = picture.pixels[at + 3];
        if (alpha == 255) continue;
        for (std::size_t c = 0; c < 3; ++c)
            picture.pixels[at + c] = static_cast<std::uint8_t>((picture.pixels[at + c] * alpha + 127) / 255);
        picture.pixels[at + 3] = 255;
    }
}

}  // namespace

RgbaPicture read_picture(const std::string& path) {
    const std::string start = first_bytes(path, kPngSignature.size());
    if (start.empty()) throw UserError(path + ": empty; give a PNG or a JPEG");
    RgbaPicture picture = start == kPngSignature ? read_png(path) : read_with_gdal(path);
    lay_on_black(picture);
    return picture;
}

}  // namespace tedavis::host_sim
