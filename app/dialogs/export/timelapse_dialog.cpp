#include "app/dialogs/export/timelapse_dialog.h"

#include "app/session/editor.h"
#include "app/session/settings/settings.h"
#include "app/widgets/asking/save_name.h"
#include "app/widgets/habits/help_page.h"
#include "app/widgets/look/section.h"
#include "app/widgets/numbers/decimal_box.h"

#include <QCheckBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QGridLayout>
#include <QLineEdit>
#include <QProgressBar>
#include <QSettings>
#include <QSpinBox>
#include <QVBoxLayout>

namespace suffuse {

namespace {

constexpr int largestSide = 8192;
constexpr int mostFrames = 1'000'000;
constexpr int numberWidth = 140;

QString keyOf(const char *name)
{
    return QStringLiteral("export/film/") + QLatin1String(name);
}

} // namespace

TimelapseDialog::TimelapseDialog(Editor &editor, const Rect &shown, QWidget *parent)
    : ExportingDialog(tr("Export Timelapse"), QStandardPaths::MoviesLocation, parent), m_editor(editor)
{
    setHelpPage(*this, "time");
    addFields(*m_grid, shown);
    addWork(QStringLiteral("film"));
    m_left = quietLabel({}, this);
    m_column->insertWidget(m_column->indexOf(m_progress) + 1, m_left);
    for (QDoubleSpinBox *box : {m_fps, m_length})
        connect(box, &QDoubleSpinBox::valueChanged, this, &TimelapseDialog::pathChanged);
    connect(m_path, &QLineEdit::editingFinished, this, &TimelapseDialog::checkEnding);
    connect(&m_job, &TimelapseJob::progressed, this, &TimelapseDialog::showProgress);
    connect(&m_job, &TimelapseJob::finished, this, &TimelapseDialog::finish);
    restore();
    begin();
}

QDoubleSpinBox *TimelapseDialog::addNumber(int row, const QString &name, const QString &suffix, const QString &tip)
{
    auto *box = new DecimalBox(m_form);
    box->setSuffix(suffix);
    box->setFixedWidth(numberWidth);
    addField(row, name, box, tip, 2, Qt::AlignLeft);
    return box;
}

void TimelapseDialog::addFields(QGridLayout &grid, const Rect &shown)
{
    addFile(0, tr("The ending chooses the format: webm or mp4 is a video, webp an animation, and png, tiff, exr, jpg "
                  "or pfm numbered pictures, such as frame%04d.png."));
    m_area = new AreaRow(grid, 1, m_editor, shown, m_form);
    connect(m_area, &AreaRow::areaChanged, this, &TimelapseDialog::areaChanged);
    m_size = new SizeRow(grid, 3, largestSide, m_form);
    areaChanged();

    m_fps = addNumber(4, tr("Frame rate"), tr(" frames/s"), tr("How many pictures a second the film has"));
    m_fps->setRange(0.1, 240);
    m_fps->setValue(FilmOptions{}.fps);
    m_length =
        addNumber(5, tr("Length"), tr(" s"), tr("How long the film is; the painting's time is stretched over it."));
    m_length->setRange(0.1, 36'000);
    m_length->setValue(10);
    m_idle = addNumber(6, tr("Longest pause"), tr(" s"),
                       tr("Pauses in which nothing is painted or spreads are cut to this, in the painting's time."));
    m_idle->setRange(0, 1e6);
    m_idle->setValue(TimelapseOptions{}.idle);
    addQuality(7, Qt::AlignLeft);
    m_quality->setFixedWidth(numberWidth);
    addTransparent(8);
    m_loops = new QCheckBox(tr("Loop"), m_form);
    m_loops->setToolTip(tr("Animated WebP: begins anew at its end. Players decide it for videos."));
    m_loops->setChecked(true);
    grid.addWidget(m_loops, 9, 1, 1, 2);
}

void TimelapseDialog::areaChanged()
{
    // The film has as many pixels as the canvas has units, or as the window shows, within the size that videos can
    // have.
    const Rect area = m_area->area();
    double width = m_area->choice() == AreaRow::Choice::Canvas ? area.width() : 1280;
    if (const double height = width * area.height() / area.width(); height > largestSide / 4)
        width *= largestSide / 4 / height;
    m_size->setArea(area, std::min(width, double(largestSide / 4)));
}

/// What the last film was, of whatever painting. Numbers out of range count as unset.
void TimelapseDialog::restore()
{
    const QSettings &store = settings::store();
    const QString ending = store.value(keyOf("ending"), QStringLiteral("webm")).toString();
    const bool isKnown = filmEndings().contains(ending) || imageEndings().contains(ending);
    m_path->setText(suggestedExportPath(m_editor, m_place, isKnown ? ending : QStringLiteral("webm")));
    const auto restoreNumber = [&store](const char *name, QDoubleSpinBox &box) {
        bool ok = false;
        const double value = store.value(keyOf(name)).toDouble(&ok);
        if (ok && value >= box.minimum() && value <= box.maximum())
            box.setValue(value);
    };
    restoreNumber("fps", *m_fps);
    restoreNumber("length", *m_length);
    restoreNumber("idle", *m_idle);
    bool ok = false;
    if (const int quality = store.value(keyOf("quality")).toInt(&ok); ok)
        m_quality->setValue(std::clamp(quality, m_quality->minimum(), m_quality->maximum()));
    if (const double width = store.value(keyOf("width")).toDouble(&ok);
        ok && width >= 1 && width <= largestSide &&
        width * m_area->area().height() <= largestSide * m_area->area().width())
        m_size->setArea(m_area->area(), width);
    m_transparent->setChecked(store.value(keyOf("transparent"), m_transparent->isChecked()).toBool());
    m_loops->setChecked(store.value(keyOf("loops"), true).toBool());
}

void TimelapseDialog::remember()
{
    QSettings &store = settings::store();
    store.setValue(keyOf("ending"), QFileInfo(m_path->text()).suffix());
    store.setValue(keyOf("fps"), m_fps->value());
    store.setValue(keyOf("length"), m_length->value());
    store.setValue(keyOf("idle"), m_idle->value());
    store.setValue(keyOf("quality"), m_quality->value());
    store.setValue(keyOf("width"), widthBox()->value());
    store.setValue(keyOf("transparent"), m_transparent->isChecked());
    store.setValue(keyOf("loops"), m_loops->isChecked());
}

void TimelapseDialog::browse()
{
    const FileKind films{tr("Films"), filmEndings()}, pictures{tr("Numbered pictures"), imageEndings()};
    QString filter;
    const QString path =
        QFileDialog::getSaveFileName(this, windowTitle(), m_path->text(), filterOf(films) + ";;" + filterOf(pictures),
                                     &filter, QFileDialog::DontConfirmOverwrite);
    if (path.isEmpty())
        return;
    const FileKind &kind = filter == filterOf(pictures) ? pictures : films;
    const QString before = QFileInfo(m_path->text()).suffix();
    m_path->setText(withEnding(path, {films, pictures}, kind.endings.contains(before) ? before : kind.endings.front()));
}

QString TimelapseDialog::target() const
{
    const QFileInfo file(m_path->text());
    QString name = file.fileName();
    if (filmKindOf(m_path->text()) == FilmKind::Frames && !name.contains(QLatin1Char('%')) &&
        imageFormatForPath(name) != ImageFormat::Unknown)
        name.insert(name.lastIndexOf(QLatin1Char('.')), QStringLiteral("%04d"));
    return file.dir().filePath(name);
}

FilmOptions TimelapseDialog::film() const
{
    FilmOptions film;
    film.path = QFileInfo(target()).absoluteFilePath();
    film.fps = m_fps->value();
    film.frames = std::size_t(std::max(1.0, std::round(m_fps->value() * m_length->value())));
    film.width = widthBox()->value();
    film.height = heightBox()->value();
    film.image.alpha = m_transparent->isChecked();
    film.image.quality = m_quality->value();
    film.loops = m_loops->isChecked();
    return film;
}

void TimelapseDialog::pathChanged()
{
    m_hint->showHint({});
    const FilmKind kind = filmKindOf(target());
    const ImageFormat format = imageFormatForPath(target());
    m_quality->setEnabled(kind != FilmKind::Video && (format == ImageFormat::Jpeg || format == ImageFormat::WebP));
    m_loops->setEnabled(kind == FilmKind::WebP);
    if (isExporting())
        return;
    const QLocale locale;
    const QString frames = tr("%1 frames").arg(locale.toString(qulonglong(film().frames)));
    m_left->setText(kind == FilmKind::Frames ? tr("%1: %2").arg(frames, QFileInfo(target()).fileName()) : frames);
}

bool TimelapseDialog::checkEnding()
{
    if (filmKindOf(target()) != FilmKind::Frames || imageFormatForPath(target()) != ImageFormat::Unknown)
        return true;
    QStringList endings = filmEndings() + imageEndings();
    endings.removeDuplicates(); // WebP is both
    m_hint->showHint(tr("“%1” has no ending of a film or a picture. Choose one of: %2.")
                         .arg(QFileInfo(m_path->text()).fileName(), endings.join(QStringLiteral(", "))));
    return false;
}

void TimelapseDialog::startExport()
{
    if (!checkEnding())
        return;
    TimelapseOrder order;
    order.film = film();
    order.idle = m_idle->value();
    order.painting = m_editor.document().painting();
    order.area = m_area->area();
    order.threads = settings::threads();
    QString problem = problemOf(order.film);
    if (problem.isEmpty() && order.film.frames > mostFrames)
        problem =
            tr("A film of %1 frames is too long. Choose a lower rate or a shorter length.").arg(order.film.frames);
    if (!problem.isEmpty()) {
        m_hint->showHint(problem.left(1).toUpper() + problem.mid(1)); // after a file's name it goes on in lower case
        return;
    }
    const QFileInfo file(order.film.path);
    if (!mayReplace(file))
        return;
    m_progress->setRange(0, int(order.film.frames));
    setBusy(true);
    m_clock.start();
    m_job.start(order);
}

void TimelapseDialog::showProgress(int frames)
{
    if (!isExporting())
        return;
    m_progress->setValue(frames);
    const int all = m_progress->maximum();
    const double left = double(m_clock.elapsed()) / 1000 / frames * (all - frames);
    const QString drawn = tr("Frame %1 of %2").arg(frames).arg(all);
    if (frames == all)
        m_left->setText(tr("Writing the film…"));
    else if (m_clock.elapsed() < 1000) // it is too early to tell how long the rest will take
        m_left->setText(drawn);
    else if (left < 90)
        m_left->setText(tr("%1; %n second(s) left", nullptr, int(std::ceil(left))).arg(drawn));
    else
        m_left->setText(tr("%1; %n minute(s) left", nullptr, int(std::ceil(left / 60))).arg(drawn));
}

void TimelapseDialog::setBusy(bool busy)
{
    ExportingDialog::setBusy(busy);
    if (!busy)
        pathChanged();
}

} // namespace suffuse
