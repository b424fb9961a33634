#include "app/dialogs/export/export_dialog.h"

#include "app/dialogs/export/preset_row.h"
#include "app/dialogs/export/print_rows.h"
#include "app/dialogs/export/profile_box.h"
#include "app/session/editor.h"
#include "app/session/settings/settings.h"
#include "app/widgets/asking/save_name.h"
#include "app/widgets/look/section.h"
#include "model/painting/resolution.h"
#include "render/layered/layered_file.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QGridLayout>
#include <QLineEdit>
#include <QLocale>
#include <QProgressBar>
#include <QSpinBox>

#include <algorithm>

namespace suffuse {

namespace {

/// Returns the path with another ending.
QString withEnding(const QString &path, const QString &ending)
{
    const qsizetype dot = path.lastIndexOf(QLatin1Char('.'));
    return path.left(dot > path.lastIndexOf(QLatin1Char('/')) ? dot : path.size()) + QLatin1Char('.') + ending;
}

QString endingOf(const QString &path)
{
    return path.section(QLatin1Char('.'), -1);
}

/// What the list of formats has for a path: the format of a picture, or that of a layered file below 0.
int formatChoiceFor(const QString &path)
{
    const LayeredFormat layered = layeredFormatFor(path);
    return layered == LayeredFormat::None ? int(imageFormatForPath(path)) : -int(layered);
}

QString formatTitle(int choice)
{
    switch (choice) {
    case -int(LayeredFormat::OpenRaster):
        return ExportDialog::tr("OpenRaster (layers)");
    case -int(LayeredFormat::Photoshop):
        return ExportDialog::tr("Photoshop (layers)");
    default:
        return nameOf(ImageFormat(choice));
    }
}

QString depthTitle(ImageDepth depth)
{
    switch (depth) {
    case ImageDepth::Bits8:
        return ExportDialog::tr("8 bit");
    case ImageDepth::Bits16:
        return ExportDialog::tr("16 bit");
    case ImageDepth::Half:
        return ExportDialog::tr("16 bit floating point");
    case ImageDepth::Float:
        return ExportDialog::tr("32 bit floating point");
    }
    return {};
}

} // namespace

ExportDialog::ExportDialog(Editor &editor, const Rect &shown, QWidget *parent)
    : ExportingDialog(tr("Export Picture"), QStandardPaths::PicturesLocation, parent), m_editor(editor)
{
    addFields(*m_grid, shown);
    addWork(QStringLiteral("export"));
    m_progress->setRange(0, 1000);
    connect(&m_job, &ExportJob::progressed, m_progress, &QProgressBar::setValue);
    connect(&m_job, &ExportJob::finished, this, &ExportDialog::finish);
    const std::optional<ExportSettings> last = exports::last();
    m_path->setText(suggestedExportPath(editor, m_place, last ? endingOf(last->path) : QStringLiteral("png")));
    if (last)
        takeFormat(*last);
    if (isResolution(
            editor.extras().resolution)) // What the sheet measures counts more than what another one was printed at.
        m_print->setPrinted(editor.extras().resolution * m_size->scale());
    if (const auto own = exports::lastOf(editor.filePath()))
        restore(*own);
    m_presets->showPresetOf(settings());
    showLimits();
    begin();
}

void ExportDialog::addFields(QGridLayout &grid, const Rect &shown)
{
    m_presets = new PresetRow(
        grid, 0, [this] { return settings(); }, m_form);
    connect(m_presets, &PresetRow::chosen, this, &ExportDialog::takePreset);
    addFile(1, tr("The ending chooses the format: png, tiff, exr, jpg, webp or pfm, or ora or psd with layers."));
    addFormat();
    m_area = new AreaRow(grid, 3, m_editor, shown, m_form);
    m_size = new SizeRow(grid, 5, maxSideOf(ImageFormat::Png), m_form);
    m_size->setArea(m_area->area());
    m_limits = quietLabel({}, m_form);
    grid.addWidget(m_limits, 6, 1, 1, 2);
    m_print = new PrintRows(grid, 7, widthBox(), heightBox(), m_form);
    m_size->leaveRoom(m_print->unitBox()->sizeHint().width()); // so that widths and heights stand below each other
    connect(m_area, &AreaRow::areaChanged, this, [this] {
        m_size->setArea(m_area->area());
        showLimits();
    });
    m_moment = new MomentRow(grid, 9, m_editor, m_form);
    m_depth = new QComboBox(m_form);
    for (const ImageDepth depth : {ImageDepth::Bits8, ImageDepth::Bits16, ImageDepth::Half, ImageDepth::Float})
        m_depth->addItem(depthTitle(depth), int(depth));
    addField(10, tr("Depth"), m_depth, tr("Precision of each colour channel"));
    addQuality(11);
    m_colours = new ProfileBox(m_editor.extras().profile, m_form);
    addField(12, tr("Colours"), m_colours,
             tr("The colour profile that the file has. The painting keeps the one that was chosen from a file."));
    connect(m_colours, &ProfileBox::refused, this, [this](const QString &why) { m_hint->showHint(why); });
    addTransparent(13);
}

/// A choice of format changes the ending of the name, and a typed ending changes the choice.
void ExportDialog::addFormat()
{
    m_format = new QComboBox(m_form);
    for (const QString &ending : exportEndings())
        if (const int format = formatChoiceFor('.' + ending); m_format->findData(format) < 0)
            m_format->addItem(formatTitle(format), format);
    m_format->setPlaceholderText(tr("No picture format"));
    addField(2, tr("Format"), m_format, tr("What is written. The ending of the file's name says the same."));
    connect(m_format, &QComboBox::activated, this, [this] {
        const QStringList all = exportEndings();
        const auto chosen = std::ranges::find_if(all, [this](const QString &ending) {
            return formatChoiceFor('.' + ending) == m_format->currentData().toInt();
        });
        // Another ending may be a part of the name, as in "edited 1.0".
        const bool replaces = pixelFormatFor(m_path->text()) != ImageFormat::Unknown;
        m_path->setText(replaces ? withEnding(m_path->text(), *chosen) : m_path->text() + '.' + *chosen);
    });
}

ExportSettings ExportDialog::settings() const
{
    ExportSettings s;
    s.path = QFileInfo(fullPath()).absoluteFilePath();
    s.depth = ImageDepth(m_depth->currentData().toInt());
    s.quality = m_quality->value();
    s.transparent = imageOptions().alpha;
    s.usesProfile = !m_colours->profile().isEmpty();
    s.dpi = m_print->dpi();
    s.area = m_area->choice();
    s.numbers = m_area->area();
    s.width = widthBox()->value();
    s.scale = m_size->scale();
    s.moment = m_moment->choice();
    s.time = m_moment->moment();
    return s;
}

/// Shows the values that belong to the format. The ending is in the path already.
void ExportDialog::takeFormat(const ExportSettings &settings)
{
    m_depth->setCurrentIndex(m_depth->findData(int(settings.depth)));
    m_quality->setValue(settings.quality);
    m_transparent->setChecked(settings.transparent);
    m_print->setDpi(settings.dpi);
    m_colours->chooseKept(settings.usesProfile);
    pathChanged();
}

void ExportDialog::takeArea(const ExportSettings &settings)
{
    if (settings.area == AreaRow::Choice::Numbers)
        m_area->setNumbers(settings.numbers);
    else
        m_area->choose(settings.area);
    m_moment->choose(settings.moment, settings.time);
}

void ExportDialog::restore(const ExportSettings &settings)
{
    if (QFileInfo(settings.path).absoluteDir().exists())
        m_path->setText(settings.path);
    else
        m_path->setText(withEnding(m_path->text(), endingOf(settings.path)));
    takeFormat(settings);
    takeArea(settings);
    m_size->setArea(m_area->area(), m_area->area().width() * settings.scale);
}

void ExportDialog::takePreset(const ExportSettings &settings)
{
    m_path->setText(withEnding(m_path->text(), endingOf(settings.path)));
    takeFormat(settings);
    takeArea(settings);
    m_size->setArea(m_area->area(), settings.width);
}

/// Tells about limits before they are hit.
void ExportDialog::showLimits()
{
    const QLocale locale;
    m_limits->setText(
        tr("At most %1 × %2 px").arg(locale.toString(widthBox()->maximum()), locale.toString(heightBox()->maximum())));
}

void ExportDialog::browse()
{
    const FileKind pictures{tr("Pictures"), exportEndings()};
    const QString path = QFileDialog::getSaveFileName(this, windowTitle(), m_path->text(), filterOf(pictures), nullptr,
                                                      QFileDialog::DontConfirmOverwrite);
    if (path.isEmpty())
        return;
    const QString before = QFileInfo(m_path->text()).suffix();
    m_path->setText(
        withEnding(path, {pictures}, pictures.endings.contains(before) ? before : pictures.endings.front()));
}

QString ExportDialog::fullPath() const
{
    const QString path = m_path->text();
    const QFileInfo file(path);
    const QString suffix = file.suffix();
    // ".doc" asks for another format, while "edited 1.0" has no ending.
    const bool asks = !suffix.isEmpty() && std::ranges::all_of(suffix, [](QChar c) { return c.isLetter(); });
    const bool isWhole = pixelFormatFor(path) != ImageFormat::Unknown || file.fileName().isEmpty() || asks;
    return isWhole || m_ending.isEmpty() ? path : path + '.' + m_ending;
}

void ExportDialog::pathChanged()
{
    if (pixelFormatFor(m_path->text()) != ImageFormat::Unknown)
        m_ending = QFileInfo(m_path->text()).suffix();
    const ImageFormat format = pixelFormatFor(fullPath());
    m_hint->showHint({});
    m_format->setCurrentIndex(m_format->findData(formatChoiceFor(fullPath())));
    m_quality->setEnabled(hasQuality(format));
    m_colours->setEnabled(hasProfile(format) && layeredFormatFor(fullPath()) == LayeredFormat::None);
    if (format != ImageFormat::Unknown)
        m_size->setLargestSide(maxSideOf(format));
    showLimits();
    // The depth is kept where the new format has it, too.
    ImageOptions options = imageOptions();
    if (format != ImageFormat::Unknown && !problemOf(format, options, 1, 1).isEmpty()) {
        options.alpha = false;
        if (!problemOf(format, options, 1, 1).isEmpty())
            m_depth->setCurrentIndex(m_depth->findData(int(usualDepth(format))));
    }
    // The background of a layered file is a layer that can be hidden.
    m_transparent->setEnabled(format != ImageFormat::Jpeg && layeredFormatFor(fullPath()) == LayeredFormat::None);
}

ImageOptions ExportDialog::imageOptions() const
{
    ImageOptions options;
    options.depth = ImageDepth(m_depth->currentData().toInt());
    options.alpha = m_transparent->isChecked() && m_transparent->isEnabled();
    options.quality = m_quality->value();
    options.dpi = m_print->dpi();
    if (m_colours->isEnabled())
        options.profile = m_colours->profile();
    return options;
}

void ExportDialog::startExport()
{
    m_path->setText(fullPath());
    const QFileInfo target(m_path->text());
    const ImageFormat format = pixelFormatFor(m_path->text());
    const int width = widthBox()->value();
    if (format == ImageFormat::Unknown) {
        if (target.suffix().compare(QLatin1String("svg"), Qt::CaseInsensitive) == 0) {
            m_hint->showHint(tr("Pictures are written here. File ▸ Export Drawing writes SVG."));
            return;
        }
        m_hint->showHint(tr("“%1” has no ending of a picture format. Choose one of: %2.")
                             .arg(target.fileName(), exportEndings().join(QStringLiteral(", "))));
        return;
    }
    const int whole = std::max(suffuse::heightForWidth(m_area->area(), width), 1);
    const QString problem = problemOf(format, imageOptions(), width, whole);
    if (!problem.isEmpty()) {
        m_hint->showHint(problem);
        return;
    }
    if (!mayReplace(target))
        return;

    ExportOrder order;
    order.path = target.absoluteFilePath();
    order.painting = m_editor.document().painting();
    order.time = m_moment->moment();
    order.area = m_area->area();
    order.width = width;
    order.height = whole;
    order.image = imageOptions();
    order.transparent = order.image.alpha;
    order.threads = suffuse::settings::threads();
    setBusy(true);
    m_job.start(order);
}

void ExportDialog::remember()
{
    m_editor.extras().profile = m_colours->kept();
    exports::remember(m_editor.filePath(), settings());
}

} // namespace suffuse
