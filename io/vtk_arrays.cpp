#include "io/vtk_arrays.h"

#include <vtkDoubleArray.h>
#include <vtkErrorCode.h>
#include <vtkLogger.h>
#include <vtkOutputWindow.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkTypeInt32Array.h>
#include <vtkTypeInt64Array.h>
#include <vtkUnsignedCharArray.h>
#include <vtkXMLPolyDataWriter.h>

#include <sstream>

#include "io/atomic_file.h"

namespace furnas {
namespace {

static_assert(sizeof(Vec3<double>) == 3 * sizeof(double), "vectors are shown to VTK as three numbers each");

/// Keeps what VTK complains about instead of printing it.
class MessageWindow : public vtkOutputWindow {
 public:
  static MessageWindow* New() {
    auto* window = new MessageWindow;
    window->InitializeObjectBase();
    return window;
  }
  void DisplayText(const char* text) override { text_ += text; }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};
/// While it lives, VTK's messages are kept. VTK knows one window for all threads, so files are written by one
/// thread at a time.
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

  /// The line that names the error, without VTK's class and address; what is wrong with the disk stands in
  /// the code of the error, which may be one of the system.
  std::string gist(unsigned long code) const {
    if (code == vtkErrorCode::OutOfDiskSpaceError)
      return "no room on the disk, or a limit on the size of files";
    if (code == vtkErrorCode::CannotOpenFileError) return "it cannot be opened";
    if (code != vtkErrorCode::NoError && code < vtkErrorCode::FirstVTKErrorCode)
      return vtkErrorCode::GetStringFromErrorCode(code);
    std::istringstream lines(window_->text());
    for (std::string line; std::getline(lines, line);)
      if (const auto place = line.find("): "); place != std::string::npos) return line.substr(place + 3);
    return "unknown error";
  }

 private:
  vtkSmartPointer<vtkOutputWindow> window_before_ = vtkOutputWindow::GetInstance();
  vtkLogger::Verbosity verbosity_before_ = vtkLogger::GetCurrentVerbosityCutoff();
  vtkSmartPointer<MessageWindow> window_ = vtkSmartPointer<MessageWindow>::New();
};

template <class Array, class T>
vtkSmartPointer<Array> view_numbers(const char* name, const T* numbers, std::size_t count, int components) {
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  constexpr int caller_keeps_it = 1;
  array->SetArray(const_cast<T*>(numbers), static_cast<vtkIdType>(count), caller_keeps_it);
  return array;
}

vtkSmartPointer<vtkDoubleArray> view_vectors(const char* name, const std::vector<Vec3<double>>& values) {
  const double* const numbers = values.empty() ? nullptr : &values.front().x;
  return view_numbers<vtkDoubleArray>(name, numbers, 3 * values.size(), 3);
}

}  // namespace

vtkSmartPointer<vtkDataArray> view(const char* name, const std::vector<double>& values) {
  return view_numbers<vtkDoubleArray>(name, values.data(), values.size(), 1);
}

vtkSmartPointer<vtkDataArray> view(const char* name, const std::vector<Vec3<double>>& values) {
  return view_vectors(name, values);
}

vtkSmartPointer<vtkDataArray> view(const char* name, const std::vector<std::uint8_t>& values) {
  return view_numbers<vtkUnsignedCharArray>(name, values.data(), values.size(), 1);
}

vtkSmartPointer<vtkDataArray> view(const char* name, const std::vector<std::int32_t>& values,
                                   int components) {
  return view_numbers<vtkTypeInt32Array>(name, values.data(), values.size(), components);
}

vtkSmartPointer<vtkDataArray> view(const char* name, const std::vector<std::int64_t>& values) {
  // A type of its own in VTK: long long where int64_t is long, of the same size.
  return view_numbers<vtkTypeInt64Array>(name, reinterpret_cast<const vtkTypeInt64*>(values.data()),
                                         values.size(), 1);
}

vtkSmartPointer<vtkPoints> view(const std::vector<Vec3<double>>& points) {
  auto result = vtkSmartPointer<vtkPoints>::New();
  result->SetData(view_vectors(nullptr, points));
  return result;
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
  if (writer->Write() != 1 || writer->GetErrorCode() != 0)
    throw OutputError(path.string() + ": cannot write the file: " + messages.gist(writer->GetErrorCode()));
  file.commit();
}

}  // namespace furnas
