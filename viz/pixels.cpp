#include "viz/pixels.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>

#include "io/atomic_file.h"

namespace furnas {
namespace {

vtkNew<vtkImageData> as_vtk(const Pixels& pixels, int channels) {
  vtkNew<vtkImageData> data;
  data->SetDimensions(pixels.width, pixels.height, 1);
  data->AllocateScalars(VTK_UNSIGNED_CHAR, channels);
  auto* out = static_cast<std::uint8_t*>(data->GetScalarPointer());
  for (std::size_t k = 0; k < pixels.rgba.size(); k += 4, out += channels)
    std::copy_n(pixels.rgba.data() + k, channels, out);
  return data;
}

}  // namespace

void write_png(const Pixels& pixels, const std::filesystem::path& path, bool opacity) {
  // To memory: VTK's own writing reports a full disk or a missing folder only by printing.
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(as_vtk(pixels, opacity ? 4 : 3));
  writer->WriteToMemoryOn();
  writer->Write();
  vtkUnsignedCharArray& bytes = *writer->GetResult();
  write_file(path, {reinterpret_cast<const char*>(bytes.GetPointer(0)),
                    static_cast<std::size_t>(bytes.GetNumberOfValues())});
}

}  // namespace furnas
