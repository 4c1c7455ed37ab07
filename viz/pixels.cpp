#include "viz/pixels.h"

#include <vtkImageData.h>
#include <vtkJPEGWriter.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>

#include "engine/base/require.h"
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

/// Encodes to memory, because VTK reports a full disk or a missing folder only by printing a message.
template <class Writer>
void write_with(Writer& writer, const Pixels& pixels, int channels, const std::filesystem::path& path) {
  writer.SetInputData(as_vtk(pixels, channels));
  writer.WriteToMemoryOn();
  writer.Write();
  vtkUnsignedCharArray& bytes = *writer.GetResult();
  write_file(path, {reinterpret_cast<const char*>(bytes.GetPointer(0)),
                    static_cast<std::size_t>(bytes.GetNumberOfValues())});
}

bool is_jpeg(const std::filesystem::path& path) {
  return path.extension() == ".jpg" || path.extension() == ".jpeg";
}

}  // namespace

void require_picture_file(const std::filesystem::path& path, bool opacity) {
  if (path.extension() != ".png" && !is_jpeg(path))
    throw InputError(path.string() +
                     ": its extension names no format of pictures; allowed: .png, .jpg, .jpeg");
  if (opacity && is_jpeg(path))
    throw InputError(path.string() + ": a JPEG cannot be transparent; allowed: .png");
}

void write_picture(const Pixels& pixels, const std::filesystem::path& path, bool opacity) {
  require_picture_file(path, opacity);
  if (!is_jpeg(path)) return write_png(pixels, path, opacity);
  vtkNew<vtkJPEGWriter> writer;
  writer->SetQuality(95);
  write_with(*writer, pixels, 3, path);
}

void write_png(const Pixels& pixels, const std::filesystem::path& path, bool opacity) {
  vtkNew<vtkPNGWriter> writer;
  write_with(*writer, pixels, opacity ? 4 : 3, path);
}

}  // namespace furnas
