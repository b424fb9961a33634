// Who may know whom: ARCHITECTURE.md's table, checked against every #include. That no more than two units know each
// other in a circle. And that no two types share a name.
#include "tests/cli/sources.h"

#include <QLibraryInfo>
#include <QMultiMap>
#include <QRegularExpression>
#include <QTest>

#include <map>
#include <set>

namespace {

/// What the files of a folder may include. The longest matching path decides.
struct Rule {
    QString path;
    QStringList own;        ///< the project's folders
    QStringList qt;         ///< Qt modules
    QStringList packages;   ///< first part of other libraries' headers
    QStringList never = {}; ///< of the project's folders, what is left out
};

const QList<Rule> &rules()
{
    static const QStringList below = {"model/", "undo/", "render/", "app/extensions/", "app/session/"};
    static const QStringList widgets = {"QtCore", "QtGui", "QtWidgets"};
    // A picture's parts know no backend, a backend no other one, and none the factory, which knows them all.
    static const QStringList backends = {
        "render/backends", "render/fallback_renderer", "render/starting_renderer", "render/cpu/",
        "render/cuda/",    "render/reference/"};
    static const auto allBut = [](const QString &own) {
        QStringList others = backends;
        others.removeAll(own);
        return others;
    };
    static const QList<Rule> table = {
        {"model/", {"model/"}, {"QtCore"}, {"Eigen", "unsupported", "zlib.h", "zstd.h"}},
        // Parts of zip files.
        {"model/formats/ora/", {"model/"}, {"QtCore"}, {"minizip"}},
        // Where the structure of PDF files is known, the program is not.
        {"model/formats/pdf/module_",
         {"model/formats/pdf/module_", "model/formats/pdf/pdf_module_api.h", "model/module_guard.h"},
         {},
         {"qpdf"}},
        {"model/module_guard.h", {}, {}, {}},
        {"model/geometry/", {"model/geometry/"}, {}, {}},
        // Formulas in double precision: plain C++.
        {"model/paint/", {"model/"}, {}, {}},
        {"undo/", {"model/", "undo/"}, {"QtCore", "QtGui"}, {}},
        // Sets texts, and knows nothing of edits.
        {"undo/lettering/", {"model/", "undo/lettering/"}, {"QtCore", "QtGui"}, {}},
        {"render/", {"model/", "render/"}, {"QtCore"}, {"Eigen", "hwy", "tbb", "oneapi"}, backends},
        {"render/backends", {"model/", "render/"}, {"QtCore"}, {}},
        {"render/fallback_renderer", {"render/replaced_renderer.h", "render/fallback_renderer.h"}, {"QtCore"}, {}},
        {"render/starting_renderer", {"render/replaced_renderer.h", "render/starting_renderer.h"}, {"QtCore"}, {}},
        {"render/replaced_renderer", {"render/renderer.h", "render/replaced_renderer.h"}, {"QtCore"}, {}},
        // Finished pixels become bytes by the same vector instructions as they were made.
        {"render/target.",
         {"model/", "render/target.h", "render/pages.h", "render/view.h", "render/cpu/kernels.h"},
         {"QtCore"},
         {}},
        {"render/pages.", {"render/pages.h"}, {}, {}},
        // What a pixel holds is told by the equations, not by what drew it.
        {"render/probe.", {"model/", "render/"}, {"QtCore"}, {}, allBut("render/reference/")},
        {"render/threads/", {"render/threads/"}, {}, {"tbb"}},
        {"render/nodes/", {"model/", "render/math/", "render/nodes/", "render/threads/"}, {"QtCore"}, {"hwy"}},
        {"render/composition/", {"model/", "render/composition/"}, {}, {}},
        // Pictures of parts of a painting, by whatever draws them.
        {"render/layered/",
         {"model/", "render/layered/", "render/math/", "render/threads/", "render/image_io/", "render/renderer.h"},
         {"QtCore"},
         {"minizip"}},
        // Paths in double precision, which know no picture.
        {"render/contours/",
         {"model/", "render/contours/", "render/nodes/", "render/math/", "render/image_io/image_io.h"},
         {"QtCore"},
         {"hwy"}},
        // Paintings as numbers, and derivatives by them: no renderer is part of it.
        {"render/gradient/",
         {"model/", "render/gradient/", "render/math/", "render/nodes/", "render/threads/", "render/view.h",
          "render/scene/paper.h", "render/simd_targets.h"},
         {"QtCore"},
         {"hwy"}},
        // Strokes that look like a picture: by the gradient, whoever draws them afterwards.
        // Pictures of diffusion curves, which need no strokes.
        {"render/curves/", {"model/", "render/curves/", "render/threads/"}, {"QtCore"}, {}},
        {"render/fitting/",
         {"model/", "render/curves/", "render/fitting/", "render/gradient/", "render/threads/", "render/view.h",
          "render/image_io/image_io.h"},
         {"QtCore"},
         {}},
        // Strokes that look like others: pictures of parts of a painting, by whatever draws them, and a fit.
        {"render/refit/",
         {"model/", "render/fitting/", "render/refit/", "render/renderer.h", "render/target.h", "render/view.h"},
         {"QtCore"},
         {}},
        {"render/scene/",
         {"model/", "render/composition/", "render/math/", "render/nodes/", "render/scene/", "render/threads/",
          "render/renderer.h", "render/target.h", "render/view.h", "render/picture_grid.h",
          "render/image_io/image_io.h"},
         {"QtCore"},
         {}},
        {"render/cpu/", {"model/", "render/"}, {"QtCore"}, {"hwy"}, allBut("render/cpu/")},
        {"render/reference/", {"model/", "render/"}, {"QtCore"}, {}, allBut("render/reference/")},
        // What other programs show of a painting is found without knowing who draws the picture.
        {"render/drawing/", {"model/", "render/"}, {"QtCore"}, {}, backends},
        // Pictures in tiles, by whatever draws them.
        {"render/tiles/", {"model/", "render/"}, {"QtCore"}, {}, backends},
        // Written once for host and device.
        {"render/math/", {"render/math/", "model/painting/style.h", "model/painting/blend.h"}, {}, {"hwy"}},
        {"render/cuda/",
         {"model/", "render/"},
         {"QtCore"},
         {"cuda_runtime.h", "cuda_pipeline.h"},
         allBut("render/cuda/")},
        // Programs of one warp, for device and host: what they work on, and nothing of who starts them.
        {"render/cuda/tiles/",
         {"render/cuda/tiles/", "render/cuda/warp.h", "render/math/"},
         {},
         {"cuda_runtime.h", "cuda_pipeline.h"}},
        {"render/cuda/nodes/",
         {"render/cuda/nodes/", "render/cuda/warp.h", "render/math/"},
         {},
         {"cuda_runtime.h", "cuda_pipeline.h"}},
        {"render/cuda/gradient/",
         {"render/cuda/gradient/", "render/cuda/warp.h", "render/math/", "model/painting/style.h"},
         {},
         {"cuda_runtime.h", "cuda_pipeline.h"}},
        {"render/cuda/device/",
         {"render/cuda/device/", "render/cuda/gradient/", "render/cuda/nodes/", "render/cuda/tiles/",
          "model/environment.h"},
         {"QtCore"},
         {"cuda_runtime.h"}},
        // OpenGL by its types only: no library of it is linked.
        {"render/cuda/device/gl_interop", {"render/"}, {}, {"cuda_runtime.h", "cuda_gl_interop.h"}},
        // Where the libraries of image files are known, the program is not; where OpenImageIO is, none of the others.
        {"render/image_io/module/",
         {"render/image_io/module/", "model/module_guard.h"},
         {},
         {"Imath", "jpeglib.h", "lcms2.h", "libdeflate.h", "tiffio.h", "webp"}},
        {"render/image_io/module/openimageio", {"render/image_io/module/"}, {}, {"OpenImageIO"}},
        {"render/image_io/module/proxy", {"render/image_io/module/"}, {}, {"OpenImageIO"}},
        {"app/",
         {"model/", "undo/", "render/", "app/"},
         {"QtCore", "QtGui", "QtWidgets", "QtOpenGL", "QtOpenGLWidgets", "QtSvg"},
         {"GL", "zlib.h"}},
        // The inner walls of app: session, widgets, canvas; tools and panels beside each other; dialogs; window.
        // Programs of others on paintings, for the window and the command line alike.
        {"app/extensions/", {"model/", "app/extensions/"}, {"QtCore"}, {}},
        {"app/session/", below, {"QtCore", "QtGui"}, {}},
        {"app/widgets/", below + QStringList{"app/widgets/"}, widgets + QStringList{"QtSvg"}, {}},
        {"app/canvas/",
         below + QStringList{"app/widgets/", "app/canvas/"},
         widgets + QStringList{"QtOpenGL", "QtOpenGLWidgets"},
         {"GL", "xcb"}},
        {"app/tools/", below + QStringList{"app/widgets/", "app/canvas/", "app/tools/"}, widgets, {}},
        {"app/panels/brushes/", below + QStringList{"app/widgets/", "app/panels/brushes/"}, widgets, {}},
        {"app/panels/colour/", below + QStringList{"app/widgets/", "app/panels/colour/"}, widgets, {}},
        {"app/panels/history/", below + QStringList{"app/widgets/", "app/panels/history/"}, widgets, {}},
        {"app/panels/inspector/", below + QStringList{"app/widgets/", "app/panels/inspector/"}, widgets, {}},
        {"app/panels/probe/", below + QStringList{"app/widgets/", "app/panels/probe/"}, widgets, {}},
        {"app/panels/strokes/", below + QStringList{"app/widgets/", "app/panels/strokes/"}, widgets, {}},
        {"app/panels/timeline/", below + QStringList{"app/widgets/", "app/panels/timeline/"}, widgets, {}},
        {"app/dialogs/", below + QStringList{"app/widgets/", "app/dialogs/"}, widgets, {}},
        {"app/dialogs/print/printers", {"app/dialogs/"}, widgets + QStringList{"QtPrintSupport"}, {}},
        {"app/window/files/running_program", {"app/window/"}, widgets + QStringList{"QtDBus"}, {}},
        // suffuse-cli draws, and edits nothing but texts along strokes that an extension changes; it loads the fonts
        // for that when it needs them. The linker's header tells its build.
        {"app/cli/",
         {"model/", "render/", "app/cli/", "app/extensions/", "undo/lettering/module_api.h",
          "undo/lettering/text_setter.h", "undo/text_links.h"},
         {"QtCore"},
         {"link.h"}},
        // The Python module asks as the command line does.
        {"app/python/",
         {"model/", "undo/", "render/", "app/cli/options.h", "app/cli/pictures/film_work.h",
          "app/cli/fitting/refit_work.h", "app/cli/tiles/tiles_work.h", "app/python/"},
         {"QtCore"},
         {"pybind11"},
         {"undo/history/edit_command.h", "undo/history/kept_history.h", "undo/history/stroke_history.h",
          "undo/lettering/shaped_line.h", "undo/lettering/text_layout.h"}},
    };
    return table;
}

const Rule *ruleFor(const QString &file)
{
    const Rule *best = nullptr;
    for (const Rule &r : rules())
        if (file.startsWith(r.path) && (!best || r.path.size() > best->path.size()))
            best = &r;
    return best;
}

bool isDevice(const QString &file)
{
    return file.endsWith(".cu") || file.endsWith(".cuh");
}

/// The Qt module of a header, or empty. "QtCore/QString" and "QString" alike.
QString qtModule(const QString &header)
{
    const QString first = header.section('/', 0, 0);
    const QDir includes(QLibraryInfo::path(QLibraryInfo::HeadersPath));
    if (header.contains('/'))
        return first.startsWith("Qt") && includes.exists(first) ? first : QString();
    for (const char *module : {"QtCore", "QtGui", "QtWidgets", "QtOpenGL", "QtOpenGLWidgets", "QtSvg", "QtSvgWidgets",
                               "QtTest", "QtNetwork", "QtConcurrent", "QtPrintSupport", "QtXml", "QtSql", "QtDBus"})
        if (includes.exists(QString(module) + '/' + header))
            return module;
    return {};
}

/// Headers of the standard library and of POSIX.
bool isSystem(const QString &header)
{
    static const QRegularExpression standard("^(std)?[a-z_0-9]+$|^sys/[a-z]+\\.h$");
    static const QStringList posix = {"unistd.h", "fcntl.h",     "dlfcn.h", "signal.h",
                                      "errno.h",  "immintrin.h", "sched.h"};
    return standard.match(header).hasMatch() || posix.contains(header);
}

/// Empty if `file` may include `header`, else why not.
QString breach(const QString &file, const QString &header, bool quoted)
{
    const Rule *rule = ruleFor(file);
    if (!rule)
        return {};
    if (quoted) {
        static const QStringList folders = {"model", "undo", "render", "app", "tests"};
        if (header.endsWith(".moc") || !header.contains('/'))
            return {};
        if (!folders.contains(header.section('/', 0, 0)))
            return breach(file, header, false);
        for (const QString &never : rule->never)
            if (header.startsWith(never))
                return QString("%1 may not include %2").arg(rule->path, never);
        for (const QString &own : rule->own)
            if (header.startsWith(own))
                return {};
        return QString("%1 may include %2 only").arg(rule->path, rule->own.join(", "));
    }
    const QString qt = qtModule(header);
    if (!qt.isEmpty()) {
        if (isDevice(file))
            return "CUDA sources include no Qt";
        return rule->qt.contains(qt) ? QString() : QString("%1 is of %2").arg(header, qt);
    }
    if (isSystem(header))
        return {};
    const QString package = header.section('/', 0, 0);
    if (package == "Eigen" && (isDevice(file) || file.startsWith("render/cuda/")))
        return "CUDA sources include no Eigen";
    if (!rule->packages.contains(package))
        return QString("%1 does not know <%2>").arg(rule->path, header);
    // Matrices are the interface of the spline fit; no header may pass it on.
    if (package == "Eigen" && file.endsWith(".h") && file.startsWith("model/") && file != "model/brush/spline_fit.h")
        return "model includes Eigen in .cpp files only";
    return {};
}

struct Include {
    QString header;
    bool quoted = false;
    int line = 0;
};

QList<Include> includesOf(const QString &text)
{
    static const QRegularExpression pattern("^\\s*#\\s*include\\s*([<\"])([^>\"]+)[>\"]");
    QList<Include> out;
    int line = 0;
    for (const QString &l : text.split('\n')) {
        ++line;
        const auto match = pattern.match(l);
        if (match.hasMatch())
            out.append({match.captured(2), match.captured(1) == "\"", line});
    }
    return out;
}

QStringList breachesIn(const QString &file, const QString &text)
{
    QStringList out;
    for (const Include &i : includesOf(text)) {
        QString why = breach(file, i.header, i.quoted);
        if (why.isEmpty() && i.header == "model/brush/spline_fit.h" && file.endsWith(".h"))
            why = "headers do not pass Eigen on";
        if (!why.isEmpty())
            out.append(QString("%1:%2: %3: %4").arg(file).arg(i.line).arg(i.header, why));
    }
    return out;
}

/// Which units (a header with its source) include which.
using IncludeGraph = std::map<QString, std::set<QString>>;

QString unitOf(const QString &file)
{
    return file.section('.', 0, 0);
}

void addIncludes(IncludeGraph &graph, const QString &file, const QString &text)
{
    std::set<QString> &known = graph[unitOf(file)];
    for (const Include &i : includesOf(text))
        if (i.quoted && i.header.contains('/') && unitOf(i.header) != unitOf(file))
            known.insert(unitOf(i.header));
}

/// The units of which each includes each other one, by way of others or not: groups of two and more (Tarjan, 1972).
class Circles {
public:
    explicit Circles(const IncludeGraph &graph) : m_graph(graph)
    {
        for (const auto &[unit, known] : graph)
            if (!m_index.contains(unit))
                visit(unit);
    }
    const QList<QStringList> &found() const { return m_found; }

private:
    int visit(const QString &unit)
    {
        const int index = m_index[unit] = int(m_index.size());
        int lowest = index;
        m_open.append(unit);
        if (const auto at = m_graph.find(unit); at != m_graph.end())
            for (const QString &next : at->second) {
                if (!m_index.contains(next))
                    lowest = std::min(lowest, visit(next));
                else if (m_open.contains(next))
                    lowest = std::min(lowest, m_index.at(next));
            }
        if (lowest == index) {
            const QStringList circle = m_open.mid(m_open.indexOf(unit));
            m_open.resize(m_open.size() - circle.size());
            if (circle.size() > 1)
                m_found.append(circle);
        }
        return lowest;
    }

    const IncludeGraph &m_graph;
    std::map<QString, int> m_index;
    QStringList m_open;
    QList<QStringList> m_found;
};

/// The types that a file defines, with their namespaces: for all to link with, or `unnamed`, for itself.
QStringList typesIn(const QString &text, bool unnamed = false)
{
    static const QRegularExpression space("^(?:inline )?namespace ?([\\w:]*) ?\\{$");
    static const QRegularExpression type(
        "^(?:struct|class|union|enum|enum class) (\\w+)(?: final)?(?: :[^:].*)?(?: \\{.*)?$");
    QStringList out, spaces;
    for (const QString &l : text.split('\n')) {
        if (const auto opened = space.match(l); opened.hasMatch())
            spaces.append(opened.captured(1));
        else if (l.startsWith("} // namespace") && !spaces.isEmpty())
            spaces.removeLast();
        else if (const auto match = type.match(l); match.hasMatch() && spaces.contains(QString()) == unnamed) {
            QStringList path = spaces + QStringList(match.captured(1));
            path.removeAll(QString());
            out.append(path.join("::"));
        }
    }
    return out;
}

} // namespace

class TestLayering : public QObject {
    Q_OBJECT

private slots:
    void everyFileKeepsToItsLevel();
    void breachesAreFound_data();
    void breachesAreFound();
    void noCircleIsLargerThanTwo();
    void circlesAreFound();
    void noTwoTypesShareAName();
    void noTypeOfOneFileIsNamedAsOneOfAll();
    void typesAreFound();
    void onePlaceReadsTheEnvironment();
};

void TestLayering::everyFileKeepsToItsLevel()
{
    QStringList problems;
    const int files =
        forEachSource([&](const QString &path, const QString &text) { problems += breachesIn(path, text); });
    QVERIFY2(files > 40, "the sources were not found");
    QVERIFY2(problems.isEmpty(), qPrintable('\n' + problems.join('\n')));
}

void TestLayering::breachesAreFound_data()
{
    QTest::addColumn<QString>("file");
    QTest::addColumn<QString>("text");
    QTest::addColumn<int>("breaches");
    const auto row = [](const char *name, const char *file, const char *text, int count) {
        QTest::newRow(name) << QString(file) << QString(text) << count;
    };
    row("model may use Qt Core", "model/a.cpp", "#include <QString>\n#include <vector>\n#include <zstd.h>\n", 0);
    row("model uses no Qt Gui", "model/a.cpp", "#include <QColor>", 1);
    row("nor by its long name", "model/a.cpp", "#include <QtGui/QColor>", 1);
    row("model does not know render", "model/a.h", "#include \"render/view.h\"", 1);
    row("Eigen in a model source", "model/a.cpp", "#include <Eigen/Core>", 0);
    row("Eigen in a model header", "model/a.h", "#include <Eigen/Core>", 1);
    row("Eigen passed on by a header", "model/a.h", "#include \"model/brush/spline_fit.h\"", 1);
    row("formulas without Qt", "model/paint/a.cpp",
        "#include \"model/painting/stroke.h\"\n#include <QString>\n#include <cmath>", 1);
    row("formulas without kernels", "model/paint/a.cpp", "#include \"render/math/style.h\"", 1);
    row("undo does not know render", "undo/a.cpp", "#include \"model/a.h\"\n#include \"render/view.h\"", 1);
    row("render does not know undo", "render/a.cpp", "#include \"undo/edits.h\"", 1);
    row("quotes change nothing", "model/a.cpp", "#include \"hwy/highway.h\"", 1);
    row("render uses no Widgets", "render/a.cpp", "#include <QWidget>\n#include <QObject>", 1);
    row("OpenImageIO outside its module", "render/a.cpp", "#include <OpenImageIO/imageio.h>", 1);
    row("OpenImageIO in its module", "render/image_io/module/openimageio.cpp", "#include <OpenImageIO/imageio.h>", 0);
    row("and not in the light one", "render/image_io/module/png.cpp", "#include <OpenImageIO/imageio.h>", 1);
    row("the module does not know the program", "render/image_io/module/a.cpp", "#include \"render/target.h\"", 1);
    row("libqpdf outside its module", "model/formats/pdf/a.cpp", "#include <qpdf/QPDF.hh>", 1);
    row("libqpdf in its module", "model/formats/pdf/module_a.cpp", "#include <qpdf/QPDF.hh>", 0);
    row("which does not know the program", "model/formats/pdf/module_a.cpp", "#include \"model/result.h\"", 1);
    row("CUDA sources without Qt and Eigen", "render/cuda/a.cu", "#include <QString>\n#include <Eigen/Core>", 2);
    row("OpenGL where CUDA meets it", "render/cuda/device/gl_interop.cu", "#include <cuda_gl_interop.h>", 0);
    row("and nowhere else", "render/cuda/device/device.cu", "#include <cuda_gl_interop.h>\n#include <GL/gl.h>", 2);
    row("a warp's program without its host", "render/cuda/tiles/a.h", "#include \"render/cuda/device/device.h\"", 1);
    row("a device without its renderer", "render/cuda/device/a.cpp", "#include \"render/cuda/cuda_renderer.h\"", 1);
    row("a scene without backends", "render/scene/a.cpp",
        "#include \"render/cpu/kernels.h\"\n#include \"render/nodes/a.h\"", 1);
    row("nodes without backends", "render/nodes/a.h", "#include \"render/cuda/tiles/records.h\"", 1);
    row("a backend without others", "render/cuda/a.cpp",
        "#include \"render/cuda/a.h\"\n#include \"render/cpu/kernels.h\"\n#include \"render/scene/a.h\"", 1);
    row("render without its factory", "render/a.cpp", "#include \"render/backends.h\"", 1);
    row("the factory with all backends", "render/backends.cpp",
        "#include \"render/cpu/a.h\"\n#include \"render/cuda/a.h\"\n#include \"render/reference/a.h\"", 0);
    row("kernels without Qt", "render/math/a.h", "#include <QString>\n#include <cmath>", 1);
    row("the command line without undo", "app/cli/a.cpp",
        "#include \"undo/edits.h\"\n#include \"app/session/editor.h\"", 2);
    row("the command line without Gui", "app/cli/a.cpp", "#include <QImage>", 1);
    row("the Python module without Gui", "app/python/a.cpp",
        "#include <pybind11/numpy.h>\n#include \"undo/edits.h\"\n#include \"undo/history/edit_command.h\"\n#include "
        "<QFont>",
        2);
    row("and nobody else with Python", "app/cli/a.cpp", "#include <pybind11/numpy.h>", 1);
    row("the session without windows", "app/session/a.h", "#include <QWidget>\n#include \"app/canvas/a.h\"", 2);
    row("the session with all below", "app/session/frames/a.cpp",
        "#include \"app/session/a.h\"\n#include \"undo/edits.h\"\n#include \"render/view.h\"\n#include <QImage>", 0);
    row("the window knows all", "app/a.cpp",
        "#include \"undo/edits.h\"\n#include <QWidget>\n#include \"render/view.h\"", 0);
}

void TestLayering::breachesAreFound()
{
    QFETCH(QString, file);
    QFETCH(QString, text);
    QFETCH(int, breaches);
    const QStringList found = breachesIn(file, text);
    QVERIFY2(found.size() == breaches, qPrintable(found.join('\n')));
}

/// Who is in a circle of three cannot be read, or tested, without the other two.
void TestLayering::noCircleIsLargerThanTwo()
{
    IncludeGraph graph;
    forEachSource([&](const QString &path, const QString &text) { addIncludes(graph, path, text); });
    QVERIFY2(graph.size() > 100, "the includes were not found");
    const Circles circles(graph);
    for (const QStringList &circle : circles.found())
        QVERIFY2(circle.size() <= 2, qPrintable(circle.join(", ")));
}

void TestLayering::circlesAreFound()
{
    IncludeGraph graph;
    addIncludes(graph, "m/a.h", "#include \"m/b.h\"\n");
    addIncludes(graph, "m/b.h", "#include <vector>\n#include \"m/d.h\"");
    addIncludes(graph, "m/b.cpp", "#include \"m/b.h\"\n#include \"m/c.h\"\n");
    addIncludes(graph, "m/c.h", "#include \"m/a.h\"\n");
    addIncludes(graph, "m/d.h", "#include \"m/e.h\"\n");
    const QList<QStringList> found = Circles(graph).found();
    QCOMPARE(found.size(), 1);
    QCOMPARE(QSet<QString>(found[0].begin(), found[0].end()), QSet<QString>({"m/a", "m/b", "m/c"}));
}

/// The linker keeps one of two vectors of types of one name, and no compiler sees both.
void TestLayering::noTwoTypesShareAName()
{
    QMultiMap<QString, QString> places;
    forEachSource([&](const QString &path, const QString &text) {
        for (const QString &type : typesIn(text))
            places.insert(type, path);
    });
    QVERIFY2(places.size() > 100, "the types were not found");
    for (const QString &type : places.uniqueKeys())
        QVERIFY2(places.count(type) == 1, qPrintable(type + ": " + places.values(type).join(", ")));
}

/// Whichever files are compiled as one (SUFFUSE_UNITY), which of the two is meant must be plain.
void TestLayering::noTypeOfOneFileIsNamedAsOneOfAll()
{
    QSet<QString> ofAll;
    QMultiMap<QString, QString> ofOne;
    forEachSource([&](const QString &path, const QString &text) {
        for (const QString &type : typesIn(text))
            ofAll.insert(type);
        for (const QString &type : typesIn(text, true))
            ofOne.insert(type, path);
    });
    QVERIFY2(ofOne.size() > 30, "the types were not found");
    for (const QString &type : ofOne.uniqueKeys())
        QVERIFY2(!ofAll.contains(type), qPrintable(type + ": " + ofOne.values(type).join(", ")));
}

void TestLayering::typesAreFound()
{
    const QString text("namespace a::b {\nclass C;\nstruct D {\nenum class E : int { One };\n"
                       "namespace {\nstruct F {\n};\n} // namespace\n"
                       "class G final : public H\n{\nclass G::I : public H {\n} // namespace a::b\nunion J {");
    QCOMPARE(typesIn(text), QStringList({"a::b::D", "a::b::E", "a::b::G", "J"}));
    QCOMPARE(typesIn(text, true), QStringList("a::b::F"));
}

/// Else nobody knows which variables there are.
void TestLayering::onePlaceReadsTheEnvironment()
{
    static const QRegularExpression reads("\\b(getenv|q?putenv|setenv|qgetenv|qEnvironmentVariable\\w*)\\(");
    QStringList readers;
    forEachSource([&](const QString &path, const QString &text) {
        if (text.contains(reads))
            readers.append(path);
    });
    QCOMPARE(readers, QStringList("model/environment.cpp"));
}

QTEST_GUILESS_MAIN(TestLayering)
#include "test_layering.moc"
