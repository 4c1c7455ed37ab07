#pragma once

#include <cstddef>
#include <vector>

namespace furnas {

/// Gives `list` room for `count` elements, and an eighth more where it must get new memory, so that a list
/// that grows slowly gets new memory rarely. New memory is slow: the system clears it page by page.
template <class T>
void make_room(std::vector<T>& list, std::size_t count) {
  if (count <= list.capacity()) return;
  list = {};  // returns the old memory first
  list.reserve(count + count / 8);
}

/// Gives `list` this number of elements, whose values the caller writes.
template <class T>
void refill(std::vector<T>& list, std::size_t count) {
  make_room(list, count);
  list.resize(count);
}

/// Gives `list` this number of elements of one value.
template <class T>
void refill(std::vector<T>& list, std::size_t count, const T& value) {
  make_room(list, count);
  list.assign(count, value);
}

}  // namespace furnas
