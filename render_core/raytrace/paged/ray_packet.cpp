#include "render_core/raytrace/paged/ray_packet.hpp"

#include "render_core/raytrace/kernel/packet_kernel_list.hpp"
#include "render_core/raytrace/view_kernels.hpp"

namespace tedavis::raytrace {

template <class Height>
base::Span<const PacketKernel<Height>> packet_kernels() {
    // As many, and as wide ones, as there are of the other tracer.
    const base::Span<const ViewKernel<Height>> views = view_kernels<Height>();
    static constexpr PacketKernel<Height> kKernels[] = {
#ifdef __x86_64__
        {"avx512", 32, cross_vector16, seek_vector16},
        {"avx2", 8, cross_vector8, seek_vector8},
#endif
        {"vector4", 4, cross_vector4, seek_vector4},
        {"scalar", 1, cross_scalar, seek_scalar}};
    return base::Span<const PacketKernel<Height>>(kKernels).subspan(std::size(kKernels) - views.size(), views.size());
}

template base::Span<const PacketKernel<std::int16_t>> packet_kernels();
template base::Span<const PacketKernel<float>> packet_kernels();

}  // namespace tedavis::raytrace
