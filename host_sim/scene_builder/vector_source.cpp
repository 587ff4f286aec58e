#include "host_sim/scene_builder/vector_source.hpp"

#include <cpl_string.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <cmath>

#include "host_sim/input_file.hpp"
#include "host_sim/quiet_gdal.hpp"
#include "host_sim/terrain_builder/raster_file.hpp"
#include "host_sim/terrain_builder/raster_source.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

using Transformation = std::unique_ptr<OGRCoordinateTransformation>;

std::vector<SourcePoint> curve_points(const OGRSimpleCurve& curve, bool is_ring) {
    std::vector<SourcePoint> points;
    const int count = is_ring && curve.get_IsClosed() != 0 ? curve.getNumPoints() - 1 : curve.getNumPoints();
    for (int n = 0; n < count; ++n) {
        SourcePoint point{curve.getY(n), curve.getX(n), {}, {}};
        if (curve.Is3D() != 0) point.height_m = curve.getZ(n);
        points.push_back(point);
    }
    return points;
}

std::map<std::string, std::string> fields_of(const OGRFeature& feature) {
    std::map<std::string, std::string> fields;
    for (int n = 0; n < feature.GetFieldCount(); ++n) {
        if (feature.IsFieldSetAndNotNull(n) == 0) continue;
        std::string text = feature.GetFieldAsString(n);
        if (!text.empty()) fields[feature.GetFieldDefnRef(n)->GetNameRef()] = std::move(text);
    }
    return fields;
}

GdalDataset open_vector(const std::string& file, const CPLStringList& options) {
    GDALAllRegister();
    require_regular_file(file);
    GdalDataset dataset(GDALDataset::Open(file.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY, nullptr, options.List(), nullptr));
    if (dataset == nullptr)
        throw UserError(file + ": not a table or map that GDAL can read (" + QuietGdal::last_message() +
                        "); give CSV or GeoJSON");
    return dataset;
}

class VectorReader {
public:
    VectorReader(std::string file, std::string crs, Holes holes)
        : file_(std::move(file)), crs_(std::move(crs)), treatment_(holes) {}

    SourceFeatures read() {
        const QuietGdal quiet;
        CPLStringList options;
        options.AddString("X_POSSIBLE_NAMES=lon*,x");
        options.AddString("Y_POSSIBLE_NAMES=lat*,y");
        options.AddString("KEEP_GEOM_COLUMNS=YES");
        const GdalDataset dataset = open_vector(file_, options);
        found_.format = dataset->GetDriverName();
        for (int n = 0; n < dataset->GetLayerCount(); ++n) read(*dataset->GetLayer(n));
        if (holes_ > 0) found_.notes.push_back(file_ + ": " + std::to_string(holes_) + " holes in areas are not shown");
        if (others_ > 0)
            found_.notes.push_back(file_ + ": " + std::to_string(others_) + " features have a geometry that is not shown");
        return std::move(found_);
    }

private:
    void read(OGRLayer& layer) {
        const Transformation to_wgs84 = transformation_of(layer);
        for (int n = 0; n < layer.GetLayerDefn()->GetFieldCount(); ++n)
            found_.columns.insert(layer.GetLayerDefn()->GetFieldDefn(n)->GetNameRef());
        layer.ResetReading();
        for (auto& feature : layer) {
            ++row_;
            const OGRGeometry* const geometry = feature->GetGeometryRef();
            if (geometry == nullptr)
                throw UserError(
                    file_ + ": feature " + std::to_string(row_) +
                    " has no place; a CSV needs columns whose names begin with lon and lat, with a number in each row");
            SourceFeature read_one;
            read_one.fields = fields_of(*feature);
            const std::unique_ptr<OGRGeometry> turned(geometry->clone());
            if (to_wgs84 != nullptr && turned->transform(to_wgs84.get()) != OGRERR_NONE)
                throw UserError(file_ + ": feature " + std::to_string(row_) +
                                " lies where its system is not defined; check 'crs'");
            add(*turned, read_one);
        }
    }
    Transformation transformation_of(OGRLayer& layer) {
        OGRSpatialReference wgs84 = wgs84_longitude_latitude(), from;
        const OGRSpatialReference* const stated = layer.GetSpatialRef();
        if (!crs_.empty()) {
            if (from.SetFromUserInput(crs_.c_str()) != OGRERR_NONE)
                throw UserError(file_ + ": crs '" + crs_ + "' is unknown; name it as EPSG:4326");
            found_.system = crs_;
        } else if (stated != nullptr) {
            from = *stated;
            found_.system = stated->GetName() != nullptr ? stated->GetName() : "";
        } else {
            return nullptr;
        }
        from.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
        if (from.IsSame(&wgs84) != 0) return nullptr;
        Transformation transformation(OGRCreateCoordinateTransformation(&from, &wgs84));
        if (transformation == nullptr) throw UserError(file_ + ": cannot be brought to longitude and latitude; check 'crs'");
        return transformation;
    }
    void add(const OGRGeometry& geometry, const SourceFeature& as_read) {
        SourceFeature feature = as_read;
        switch (wkbFlatten(geometry.getGeometryType())) {
            case wkbPoint: {
                const OGRPoint& point = *geometry.toPoint();
                feature.points = {{point.getY(), point.getX(), {}, {}}};
                if (point.Is3D() != 0) feature.points[0].height_m = point.getZ();
                break;
            }
            case wkbLineString:
                feature.shape = scene::LayerShape::lines;
                feature.points = curve_points(*geometry.toLineString(), false);
                break;
            case wkbPolygon:
                feature.shape = scene::LayerShape::areas;
                feature.points = points_of(*geometry.toPolygon());
                break;
            case wkbMultiPoint:
            case wkbMultiLineString:
            case wkbMultiPolygon:
            case wkbGeometryCollection:
                for (const OGRGeometry* part : *geometry.toGeometryCollection()) add(*part, as_read);
                return;
            default: ++others_; return;
        }
        for (SourcePoint& point : feature.points) hold_to_earth(point);
        if (!feature.points.empty()) found_.features.push_back(std::move(feature));
    }
    [[nodiscard]] std::vector<SourcePoint> points_of(const OGRPolygon& polygon) {
        if (polygon.getExteriorRing() == nullptr) return {};
        std::vector<SourcePoint> points = curve_points(*polygon.getExteriorRing(), true);
        const int holes = polygon.getNumInteriorRings();
        if (treatment_ == Holes::left_out) {
            holes_ += holes;
            return points;
        }
        const SourcePoint gate = points.empty() ? SourcePoint() : points.back();
        for (int n = 0; n < holes; ++n) {
            const std::vector<SourcePoint> hole = curve_points(*polygon.getInteriorRing(n), true);
            if (hole.empty()) continue;
            points.insert(points.end(), hole.begin(), hole.end());
            points.insert(points.end(), {hole.front(), gate});
        }
        return points;
    }
    /// Longitudes of 0..360 become -180..180.
    void hold_to_earth(SourcePoint& point) const {
        if (!(std::abs(point.latitude_deg) <= 90) || !(std::abs(point.longitude_deg) <= 360))
            throw UserError(file_ + ": feature " + std::to_string(row_) + " lies at latitude " +
                            std::to_string(point.latitude_deg) + ", longitude " + std::to_string(point.longitude_deg) +
                            ", which is no place; name its system in 'crs', or correct it");
        point.longitude_deg = std::remainder(point.longitude_deg, 360);
        if (point.height_m && !std::isfinite(*point.height_m)) point.height_m.reset();
    }

    const std::string file_, crs_;
    const Holes treatment_;
    SourceFeatures found_;
    std::size_t row_ = 0;
    int holes_ = 0, others_ = 0;
};

}  // namespace

std::vector<std::map<std::string, std::string>> read_table_file(const std::string& file) {
    const QuietGdal quiet;
    const GdalDataset dataset = open_vector(file, {});
    std::vector<std::map<std::string, std::string>> rows;
    for (int n = 0; n < dataset->GetLayerCount(); ++n)
        for (auto& feature : dataset->GetLayer(n)) rows.push_back(fields_of(*feature));
    return rows;
}

SourceFeatures read_vector_file(const std::string& file, const std::string& crs, Holes holes) {
    return VectorReader(file, crs, holes).read();
}

}  // namespace tedavis::host_sim
