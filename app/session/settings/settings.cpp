#include "app/session/settings/settings.h"

#include "app/session/settings/languages.h"
#include "model/formats/atomic_save.h"
#include "model/formats/brushes/brush_file.h"

#include <QDir>
#include <QFileInfo>

#include <algorithm>

namespace suffuse::settings {

namespace {

constexpr int maxRecentFiles = 10;
constexpr int maxThreads = 256;
constexpr int usualBackups = 2;
constexpr int maxCurvePoints = 64;

} // namespace

QString language()
{
    const QString code = store().value("language").toString();
    const bool known = std::any_of(languages().begin(), languages().end(),
                                   [&code](const Language &each) { return each.code == code; });
    return known ? code : QString();
}

void setLanguage(const QString &code)
{
    store().setValue("language", code);
}

Theme theme()
{
    const QString name = store().value("theme").toString();
    return name == "dark" ? Theme::Dark : name == "light" ? Theme::Light : Theme::System;
}

void setTheme(Theme theme)
{
    store().setValue("theme", theme == Theme::Dark ? "dark" : theme == Theme::Light ? "light" : "system");
}

Presenter presenter()
{
    const QString name = store().value("presenter").toString();
    return name == "raster" ? Presenter::Raster : name == "opengl" ? Presenter::OpenGL : Presenter::Auto;
}

void setPresenter(Presenter presenter)
{
    store().setValue("presenter", presenter == Presenter::Raster   ? "raster"
                                  : presenter == Presenter::OpenGL ? "opengl"
                                                                   : "auto");
}

Backend backend()
{
    const QString name = store().value("backend").toString();
    return name == "cpu" ? Backend::Cpu : name == "cuda" ? Backend::Cuda : Backend::Auto;
}

void setBackend(Backend backend)
{
    store().setValue("backend", backend == Backend::Cpu ? "cpu" : backend == Backend::Cuda ? "cuda" : "auto");
}

int threads()
{
    const int count = store().value("threads").toInt();
    return count > 0 && count <= maxThreads ? count : 0;
}

void setThreads(int count)
{
    store().setValue("threads", count);
}

bool scalesSpread()
{
    return store().value("scalesSpread", true).toBool();
}

void setScalesSpread(bool scales)
{
    store().setValue("scalesSpread", scales);
}

bool hasSelected()
{
    return store().value("hints/hasSelected").toBool();
}

void setHasSelected()
{
    if (!hasSelected())
        store().setValue("hints/hasSelected", true);
}

CanvasAids canvasAids()
{
    const QSettings &s = store();
    CanvasAids aids;
    aids.snapToNodes = s.value("aids/snapToNodes").toBool();
    aids.snapToGrid = s.value("aids/snapToGrid").toBool();
    aids.showGrid = s.value("aids/showGrid").toBool();
    aids.showOutlines = s.value("aids/showOutlines", aids.showOutlines).toBool();
    aids.showErasures = s.value("aids/showErasures").toBool();
    aids.showBeyond = s.value("aids/showBeyond").toBool();
    aids.showSymmetry = s.value("aids/showSymmetry", aids.showSymmetry).toBool();
    aids.showRulers = s.value("aids/showRulers", aids.showRulers).toBool();
    const int units = s.value("aids/rulerUnits").toInt();
    if (units >= 0 && units <= int(RulerUnits::Inches))
        aids.rulerUnits = RulerUnits(units);
    aids.showGuides = s.value("aids/showGuides", aids.showGuides).toBool();
    aids.snapToGuides = s.value("aids/snapToGuides", aids.snapToGuides).toBool();
    aids.lockGuides = s.value("aids/lockGuides", aids.lockGuides).toBool();
    aids.showAssistants = s.value("aids/showAssistants", aids.showAssistants).toBool();
    aids.snapToAssistants = s.value("aids/snapToAssistants", aids.snapToAssistants).toBool();
    const double step = s.value("aids/gridStep", aids.gridStep).toDouble();
    if (step >= minGridStep && step <= maxGridStep)
        aids.gridStep = step;
    return aids;
}

void setCanvasAids(const CanvasAids &aids)
{
    QSettings &s = store();
    s.setValue("aids/snapToNodes", aids.snapToNodes);
    s.setValue("aids/snapToGrid", aids.snapToGrid);
    s.setValue("aids/showGrid", aids.showGrid);
    s.setValue("aids/gridStep", aids.gridStep);
    s.setValue("aids/showOutlines", aids.showOutlines);
    s.setValue("aids/showErasures", aids.showErasures);
    s.setValue("aids/showBeyond", aids.showBeyond);
    s.setValue("aids/showSymmetry", aids.showSymmetry);
    s.setValue("aids/showRulers", aids.showRulers);
    s.setValue("aids/rulerUnits", int(aids.rulerUnits));
    s.setValue("aids/showGuides", aids.showGuides);
    s.setValue("aids/snapToGuides", aids.snapToGuides);
    s.setValue("aids/lockGuides", aids.lockGuides);
    s.setValue("aids/showAssistants", aids.showAssistants);
    s.setValue("aids/snapToAssistants", aids.snapToAssistants);
}

PenSettings penSettings()
{
    PenSettings pen;
    pen.fingersMoveView = store().value("pen/fingersMoveView").toBool();
    ResponseCurve curve;
    curve.points.clear();
    for (const QString &point : store().value("pen/pressure").toStringList().mid(0, maxCurvePoints)) {
        const QStringList xy = point.split(u' ');
        curve.points.push_back({xy.value(0).toFloat(), xy.value(1).toFloat()});
    }
    if (curve.isValid())
        pen.pressure = curve;
    return pen;
}

void setPenSettings(const PenSettings &pen)
{
    store().setValue("pen/fingersMoveView", pen.fingersMoveView);
    QStringList points;
    for (const Offset &p : pen.pressure.points)
        points << QStringLiteral("%1 %2").arg(double(p.x), 0, 'g', 9).arg(double(p.y), 0, 'g', 9);
    store().setValue("pen/pressure", points);
}

Brush brush()
{
    const QByteArray bytes = QByteArray::fromBase64(store().value("brush").toString().toLatin1());
    Result<Brush> kept = readBrush(bytes, QStringLiteral("brush"));
    return kept ? std::move(*kept) : firstBrush();
}

void setBrush(const Brush &brush)
{
    store().setValue("brush", QString::fromLatin1(writeBrush(brush).toBase64()));
}

int backups()
{
    bool isNumber = false;
    const int stored = store().value("backups").toInt(&isNumber);
    return isNumber ? std::clamp(stored, 0, mostBackups) : usualBackups;
}

void setBackups(int count)
{
    store().setValue("backups", count);
}

namespace {

/// The files of a list that exist, each once.
QStringList presentFiles(const QStringList &paths)
{
    QStringList files, places;
    for (const QString &path : paths) {
        const QFileInfo info(path);
        if (files.size() == maxRecentFiles || !QDir::isAbsolutePath(path) || !info.isFile() ||
            places.contains(info.canonicalFilePath()))
            continue;
        files << path;
        places << info.canonicalFilePath();
    }
    return files;
}

} // namespace

QStringList recentFiles()
{
    store().sync(); // another instance may have added files
    return presentFiles(store().value("recentFiles").toStringList());
}

void addRecentFile(const QString &path)
{
    updateList("recentFiles", [absolute = QFileInfo(path).absoluteFilePath()](const QStringList &stored) {
        return presentFiles(QStringList(absolute) + stored);
    });
}

void clearRecentFiles()
{
    updateList("recentFiles", [](const QStringList &) { return QStringList(); });
}

} // namespace suffuse::settings
