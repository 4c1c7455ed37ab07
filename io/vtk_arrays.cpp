#include "io/vtk_arrays.h"

#include <fmt/format.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkLogger.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkTypeInt32Array.h>
#include <vtkTypeInt64Array.h>
#include <vtkUnsignedCharArray.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLPolyDataWriter.h>

#include <algorithm>
#include <charconv>
#include <fstream>

#include "engine/base/require.h"
#include "io/atomic_file.h"
#include "io/text_reader.h"

namespace furnas {
namespace {

static_assert(sizeof(Vec3<double>) == 3 * sizeof(double), "vectors are shown to VTK as three numbers each");

/// Keeps what VTK complains about instead of printing it.
class MessageWindow : public vtkOutputWindow {
 public:
  static MessageWindow* New();
  void DisplayText(const char* text) override { text_ += text; }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};
vtkStandardNewMacro(MessageWindow)

    /// While it lives, VTK's messages are kept. VTK knows one window for all threads, so files are read and
    /// written by one thread at a time.
    class Messages {
 public:
  Messages() {
    vtkOutputWindow::SetInstance(window_);
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);  // it prints the same once more
  }
  ~Messages() {
    vtkOutputWindow::SetInstance(window_before_);
    vtkLogger::SetStderrVerbosity(verbosity_before_);
  }
  Messages(const Messages&) = delete;
  Messages& operator=(const Messages&) = delete;

  bool any() const { return !window_->text().empty(); }

  /// The last line that says something, without VTK's class and address.
  std::string gist() const {
    std::string text = window_->text();
    while (!text.empty() && text.back() == '\n') text.pop_back();
    text = text.substr(text.rfind('\n') + 1);
    if (const auto place = text.find("): "); place != std::string::npos) text = text.substr(place + 3);
    return text.empty() ? "unknown error" : text;
  }

 private:
  vtkSmartPointer<vtkOutputWindow> window_before_ = vtkOutputWindow::GetInstance();
  vtkLogger::Verbosity verbosity_before_ = vtkLogger::GetCurrentVerbosityCutoff();
  vtkSmartPointer<MessageWindow> window_ = vtkSmartPointer<MessageWindow>::New();
};

vtkSmartPointer<vtkDoubleArray> view_numbers(const double* numbers, std::size_t tuples, int components) {
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetNumberOfComponents(components);
  constexpr int caller_keeps_it = 1;
  array->SetArray(const_cast<double*>(numbers), static_cast<vtkIdType>(tuples) * components, caller_keeps_it);
  return array;
}

const double* numbers_of(const std::vector<Vec3<double>>& values) {
  return values.empty() ? nullptr : &values.front().x;
}

template <class Array, class T>
vtkSmartPointer<vtkDataArray> copy_numbers(const char* name, const std::vector<T>& values, int components) {
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()) / components);
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  return array;
}

/// More bytes than a file can hold: zlib shrinks data at most 1032 times.
std::uint64_t most_bytes(std::uint64_t file_size) { return file_size * 1032; }

/// VTK allocates the arrays that a file announces before it looks for them; none may be too long to be there.
void check_announced_lengths(const std::filesystem::path& path, std::uint64_t size) {
  constexpr std::size_t most_header = std::size_t{1} << 20;
  std::string header(static_cast<std::size_t>(std::min<std::uint64_t>(size, most_header)), '\0');
  std::ifstream(path, std::ios::binary).read(header.data(), static_cast<std::streamsize>(header.size()));
  for (const std::string_view key :
       {"NumberOfTuples=\"", "NumberOfComponents=\"", "NumberOfPoints=\"", "NumberOfVerts=\"",
        "NumberOfLines=\"", "NumberOfStrips=\"", "NumberOfPolys=\""}) {
    for (auto at = header.find(key); at != std::string::npos; at = header.find(key, at + 1)) {
      std::uint64_t length = 0;
      const char* begin = header.data() + at + key.size();
      const auto [end, error] = std::from_chars(begin, header.data() + header.size(), length);
      if (error != std::errc{} || length > most_bytes(size))
        throw InputError(fmt::format("{}: {}... is more than a file of {} bytes can hold, or no number",
                                     path.string(), key, size));
    }
  }
}

}  // namespace

vtkSmartPointer<vtkDataArray> view(const char* name, const std::vector<double>& values) {
  auto array = view_numbers(values.data(), values.size(), 1);
  array->SetName(name);
  return array;
}

vtkSmartPointer<vtkDataArray> view(const char* name, const std::vector<Vec3<double>>& values) {
  auto array = view_numbers(numbers_of(values), values.size(), 3);
  array->SetName(name);
  return array;
}

vtkSmartPointer<vtkPoints> view(const std::vector<Vec3<double>>& points) {
  auto result = vtkSmartPointer<vtkPoints>::New();
  result->SetData(view_numbers(numbers_of(points), points.size(), 3));
  return result;
}

vtkSmartPointer<vtkDataArray> copy(const char* name, const std::vector<std::uint8_t>& values) {
  return copy_numbers<vtkUnsignedCharArray>(name, values, 1);
}

vtkSmartPointer<vtkDataArray> copy(const char* name, const std::vector<std::int32_t>& values,
                                   int components) {
  return copy_numbers<vtkTypeInt32Array>(name, values, components);
}

vtkSmartPointer<vtkDataArray> copy(const char* name, const std::vector<std::int64_t>& values) {
  return copy_numbers<vtkTypeInt64Array>(name, values, 1);
}

vtkDataArray* find_array(vtkFieldData* from, const char* name, std::int64_t tuples, int components,
                         const std::string& file) {
  vtkDataArray* array = from->GetArray(name);
  if (!array) return nullptr;
  if (array->GetNumberOfTuples() != tuples || array->GetNumberOfComponents() != components)
    throw InputError(fmt::format("{}: the array {} has {} times {} numbers; expected {} times {}", file, name,
                                 array->GetNumberOfTuples(), array->GetNumberOfComponents(), tuples,
                                 components));
  return array;
}

void write_poly_data(vtkPolyData* data, const std::filesystem::path& path) {
  AtomicFile file(path);
  const Messages messages;
  const auto writer = vtkSmartPointer<vtkXMLPolyDataWriter>::New();
  writer->SetFileName(file.temporary().c_str());
  writer->SetInputData(data);
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();
  writer->SetCompressorTypeToZLib();
  writer->SetHeaderTypeToUInt64();
  if (writer->Write() != 1 || writer->GetErrorCode() != 0 || messages.any())
    throw OutputError(path.string() + ": cannot write the file: " + messages.gist());
  file.commit();
}

vtkSmartPointer<vtkPolyData> read_poly_data(const std::filesystem::path& path) {
  const std::uint64_t size = readable_size(path);
  check_announced_lengths(path, size);
  const Messages messages;
  const auto reader = vtkSmartPointer<vtkXMLPolyDataReader>::New();
  const auto fail = [&](const std::string& what) {
    throw InputError(path.string() + ": not a readable VTK XML file of poly data: " + what);
  };
  try {
    reader->SetFileName(path.c_str());
    reader->Update();
  } catch (const std::exception& error) {  // a damaged length inside the data
    fail(error.what());
  }
  if (reader->GetErrorCode() != 0 || messages.any() || !reader->GetOutput()) fail(messages.gist());
  return reader->GetOutput();
}

}  // namespace furnas
