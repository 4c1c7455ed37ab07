#include "engine/events/renew_order.h"

#include "engine/search/size_classes.h"

namespace furnas {

std::optional<Verdict> RenewOrder::fire(Observation& now) {
  Packing packing = now.take_packing();
  packing.order = memory_order(packing);
  now.replace(packing);
  return {};
}

}  // namespace furnas
