// `import suffuse`: what all parts of the module share, and the module itself.
#include "app/python/bindings.h"
#include "model/module_path.h"

#include <QRegularExpression>
#include <QString>

#include <condition_variable>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <thread>

namespace suffuse::python {

namespace {

/// They live as long as Python does.
struct Errors {
    py::object plain, value, file, leftOut;
};
Errors &errors()
{
    static auto *const all = new Errors;
    return *all;
}

py::object newClass(const char *name, const char *doc, const py::object &bases)
{
    return py::reinterpret_steal<py::object>(PyErr_NewExceptionWithDoc(name, doc, bases.ptr(), nullptr));
}

/// Gives a function of this module a docstring. Python has no way to do that, so this is what pybind11 does itself.
void setDoc(const py::object &function, const std::string &text)
{
    PyObject *const inner =
        PyInstanceMethod_Check(function.ptr()) ? PyInstanceMethod_GET_FUNCTION(function.ptr()) : function.ptr();
    if (!PyCFunction_Check(inner))
        throw py::type_error("no function of this module");
    PyMethodDef *const definition = reinterpret_cast<PyCFunctionObject *>(inner)->m_ml;
    std::free(const_cast<char *>(definition->ml_doc)); // NOLINT(cppcoreguidelines-no-malloc): pybind11's memory
    definition->ml_doc = ::strdup(text.c_str());
}

/// Whether the caller is the thread that Python's signals come to.
bool isMainThread()
{
    const py::module_ threading = py::module_::import("threading");
    return threading.attr("current_thread")().is(threading.attr("main_thread")());
}

/// Work on a thread of its own, so that the caller can listen to signals.
class AsideWork {
public:
    AsideWork(const std::function<void(std::atomic<bool> &)> &work, std::atomic<bool> &cancel)
        : m_thread([this, &work, &cancel] {
              try {
                  work(cancel);
              } catch (...) {
                  m_failure = std::current_exception();
              }
              const std::lock_guard lock(m_mutex);
              m_isDone = true;
              m_ended.notify_all();
          })
    {}
    /// Returns whether it has ended within some time.
    bool waitFor(std::chrono::milliseconds time)
    {
        std::unique_lock lock(m_mutex);
        return m_ended.wait_for(lock, time, [this] { return m_isDone; });
    }
    void end()
    {
        m_thread.join();
        if (m_failure)
            std::rethrow_exception(m_failure);
    }

private:
    std::mutex m_mutex;
    std::condition_variable m_ended;
    bool m_isDone = false;
    std::exception_ptr m_failure;
    std::thread m_thread; ///< begins when all else is there
};

} // namespace

QString inPython(QString message)
{
    static const QRegularExpression option(QStringLiteral("--([a-z])")), one(QStringLiteral("\\b1 ([\\w ]+?)\\(s\\)")),
        many(QStringLiteral("(\\w)\\(s\\)")), were(QStringLiteral("(^|: |\\. )(1 [^,.]+) were left out"));
    message.replace(option, QStringLiteral("\\1"));
    message.replace(one, QStringLiteral("1 \\1"));
    message.replace(were, QStringLiteral("\\1\\2 was left out"));
    return message.replace(many, QStringLiteral("\\1s"));
}

PaintingValue derivedFrom(const PaintingValue &from, PaintingPtr painting)
{
    auto extras = std::make_shared<DocumentExtras>(*from.extras);
    extras->preview.clear();
    extras->history.clear();
    return {std::move(painting), std::move(extras), {}};
}

void addErrors(py::module_ &module)
{
    const py::object exception = py::reinterpret_borrow<py::object>(PyExc_Exception);
    const auto both = [](const py::object &a, PyObject *b) {
        return py::make_tuple(a, py::reinterpret_borrow<py::object>(b));
    };
    Errors &all = errors();
    all.plain = newClass("suffuse.Error", "What Suffuse could not do, in the words of the command line.", exception);
    all.value = newClass("suffuse.DataError",
                         "A value, a table or the content of a file that cannot be. The text names the place.",
                         both(all.plain, PyExc_ValueError));
    all.file = newClass("suffuse.FileError", "A file that cannot be read or written. The text says what to do.",
                        both(all.plain, PyExc_OSError));
    all.leftOut =
        newClass("suffuse.LeftOutWarning", "What a file has and a painting cannot have, or what is missing of it.",
                 py::reinterpret_borrow<py::object>(PyExc_UserWarning));
    module.attr("Error") = all.plain;
    module.attr("DataError") = all.value;
    module.attr("FileError") = all.file;
    module.attr("LeftOutWarning") = all.leftOut;
}

void raise(Raised kind, const QString &message)
{
    const Errors &all = errors();
    const py::object &type = kind == Raised::File ? all.file : kind == Raised::Value ? all.value : all.plain;
    PyErr_SetObject(type.ptr(), py::cast(inPython(message)).ptr());
    throw py::error_already_set();
}

void warnLeftOut(const QString &message)
{
    if (PyErr_WarnEx(errors().leftOut.ptr(), inPython(message).toUtf8().constData(), 2) != 0)
        throw py::error_already_set();
}

void withoutLock(const std::function<void(std::atomic<bool> &cancel)> &work, const std::function<void()> &tell)
{
    std::atomic<bool> cancel{false};
    const bool listens = isMainThread();
    if (!listens && !tell) {
        const py::gil_scoped_release released;
        work(cancel);
        return;
    }
    bool isStopped = false;
    const auto look = [&] {
        try {
            if (listens && PyErr_CheckSignals() != 0)
                throw py::error_already_set();
            if (tell)
                tell();
        } catch (py::error_already_set &error) {
            error.restore(); // until the work has ended
            cancel = isStopped = true;
        }
    };
    {
        const py::gil_scoped_release released;
        AsideWork aside(work, cancel);
        while (!aside.waitFor(std::chrono::milliseconds(50))) {
            const py::gil_scoped_acquire locked;
            if (!isStopped)
                look();
        }
        aside.end();
    }
    if (!isStopped && tell)
        look();
    if (isStopped)
        throw py::error_already_set();
}

QString pathOf(const py::object &path)
{
    const py::object text = py::module_::import("os").attr("fsdecode")(path);
    return text.cast<QString>();
}

} // namespace suffuse::python

PYBIND11_MODULE(_suffuse, module)
{
    using namespace suffuse::python;
    py::options options;
    options.disable_function_signatures(); // The stubs have them.
    module.doc() = "The compiled part of suffuse.";
    module.attr("__version__") = SUFFUSE_VERSION;
    addErrors(module);
    module.def("set_doc", &setDoc);
    module.def("set_module_folder", [](const QString &folder) { suffuse::setModuleFolder(folder); });
    addPaintings(module);
    addDocuments(module);
    addPictures(module);
    addProbes(module);
    addGradients(module);
    addFits(module);
    addRefits(module);
    addTiles(module);
    addFilms(module);
}
