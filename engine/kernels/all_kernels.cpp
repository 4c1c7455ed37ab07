// This file is compiled once for each instruction set. The compiler's flags choose the set; FURNAS_KERNELS is
// its namespace.

#include "engine/kernels/contact_kernel.h"
#include "engine/kernels/drift_kernel.h"
#include "engine/kernels/gather_kernel.h"
#include "engine/kernels/kernels.h"

namespace furnas::FURNAS_KERNELS {
namespace {

template <class S>
ContactSum contacts(const ContactLoop<S>& loop, std::size_t begin, std::size_t end) {
  return HWY_NAMESPACE::ContactKernel<S>(loop)(begin, end);
}

template <class S>
double drift(const DriftLoop<S>& loop, std::size_t begin, std::size_t end) {
  return HWY_NAMESPACE::DriftKernel<S>(loop)(begin, end);
}

template <class S>
Triangle gather(const GatherLoop<S>& loop, std::size_t begin, std::size_t end) {
  return HWY_NAMESPACE::GatherKernel<S>(loop)(begin, end);
}

}  // namespace

template <class S>
Kernels<S> kernels() {
  return {contacts<S>, drift<S>, gather<S>};
}

#define FURNAS_INSTANTIATE(Law, Real) template Kernels<Numerics<Law, Real>> kernels<Numerics<Law, Real>>();
FURNAS_FOR_EACH_NUMERICS(FURNAS_INSTANTIATE)
#undef FURNAS_INSTANTIATE

}  // namespace furnas::FURNAS_KERNELS
