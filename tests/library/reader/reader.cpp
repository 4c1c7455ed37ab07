#include <iostream>

#include "io/formats.h"

int main(int count, char** arguments) {
  for (int k = 1; k < count; ++k)
    std::cout << "spheres: " << furnas::read_packing(arguments[k]).size() << '\n';
}
