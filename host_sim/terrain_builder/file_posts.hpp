/// Posts of raster files.
#pragma once

#include <string>
#include <vector>

#include "host_sim/terrain_builder/post_reader.hpp"
#include "host_sim/terrain_builder/post_source.hpp"

namespace tedavis::host_sim {

class FilePosts final : public PostReader {
public:
    /// Throws UserError.
    FilePosts(const std::vector<std::string>& files, const RasterOptions& options) : posts_(files, options) {
        grid_.columns = posts_.columns();
        grid_.rows = posts_.rows();
        grid_.west_deg = posts_.west_deg();
        grid_.north_deg = posts_.north_deg();
        grid_.step_lon_deg = posts_.step_lon_deg();
        grid_.step_lat_deg = posts_.step_lat_deg();
        grid_.source = posts_.source();
        grid_.vertical_datum = posts_.vertical_datum();
    }

    [[nodiscard]] const PostGrid& grid() const override { return grid_; }
    [[nodiscard]] const std::vector<std::string>& notes() const { return posts_.notes(); }
    void read(std::uint32_t i, std::uint32_t j, std::uint32_t columns, std::uint32_t rows, base::Span<float> heights_m,
              base::Span<terrain::PostClass> classes) override {
        posts_.read(i, j, columns, rows, heights_m, classes);
    }

private:
    PostSource posts_;
    PostGrid grid_;
};

}  // namespace tedavis::host_sim
