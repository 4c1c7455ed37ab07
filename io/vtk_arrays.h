#pragma once

#include <vtkSmartPointer.h>

#include <cstdint>
#include <filesystem>
#include <vector>

#include "engine/base/vec3.h"

class vtkDataArray;
class vtkPoints;
class vtkPolyData;

namespace furnas {

/// An array that shows VTK the caller's numbers without a copy; they must outlive it and are not changed.
vtkSmartPointer<vtkDataArray> view(const char* name, const std::vector<double>& values);
vtkSmartPointer<vtkDataArray> view(const char* name, const std::vector<Vec3<double>>& values);
vtkSmartPointer<vtkDataArray> view(const char* name, const std::vector<std::uint8_t>& values);
vtkSmartPointer<vtkDataArray> view(const char* name, const std::vector<std::int32_t>& values,
                                   int components = 1);
vtkSmartPointer<vtkDataArray> view(const char* name, const std::vector<std::int64_t>& values);
vtkSmartPointer<vtkPoints> view(const std::vector<Vec3<double>>& points);

/// Writes a VTK XML file of raw appended data, compressed with zlib; throws OutputError.
void write_poly_data(vtkPolyData* data, const std::filesystem::path& path);

}  // namespace furnas
