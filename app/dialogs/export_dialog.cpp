#include "app/dialogs/export_dialog.h"

#include "app/editor.h"
#include "app/panels/section.h"
#include "app/settings.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QGridLayout>
#include <QLineEdit>
#include <QMessageBox>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>
#include <QStandardPaths>

namespace suffuse {

namespace {

constexpr int largestSide = 30000;
constexpr qint64 mostPixels = qint64(1) << 27; ///< 2 GiB of floats

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

ExportDialog::ExportDialog(Editor &editor, QWidget *parent) : QDialog(parent), m_editor(editor)
{
    setWindowTitle(tr("Export picture"));
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(16, 16, 16, 16);
    column->setSpacing(12);
    m_form = new QWidget(this);
    auto *grid = new QGridLayout(m_form);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(16);
    grid->setVerticalSpacing(8);
    grid->setColumnStretch(1, 1);
    addFields(*grid);
    column->addWidget(m_form);
    m_progress = new QProgressBar(this);
    m_progress->setRange(0, 1000);
    m_progress->setTextVisible(false);
    m_progress->setAccessibleName(tr("Progress"));
    m_progress->hide();
    column->addWidget(m_progress);
    m_hint = new HintLabel(this);
    column->addWidget(m_hint);
    column->addStretch(1);
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    m_export = buttons->addButton(tr("Export"), QDialogButtonBox::AcceptRole);
    m_export->setDefault(true);
    m_cancel = buttons->button(QDialogButtonBox::Cancel);
    column->addWidget(buttons);

    connect(m_export, &QPushButton::clicked, this, &ExportDialog::startExport);
    connect(buttons, &QDialogButtonBox::rejected, this, &ExportDialog::reject);
    connect(m_path, &QLineEdit::textChanged, this, &ExportDialog::formatChanged);
    connect(&m_job, &ExportJob::progressed, m_progress, &QProgressBar::setValue);
    connect(&m_job, &ExportJob::finished, this, &ExportDialog::exportFinished);
    m_path->setText(suggestedPath());
    setMinimumWidth(480);
}

void ExportDialog::addFields(QGridLayout &grid)
{
    const auto add = [&](int row, const QString &name, QWidget *field, const QString &tip) {
        auto *label = new QLabel(name, m_form);
        label->setBuddy(field);
        field->setAccessibleName(name);
        field->setToolTip(tip);
        grid.addWidget(label, row, 0);
        grid.addWidget(field, row, 1, 1, field == m_path ? 1 : 2);
    };
    m_path = new QLineEdit(m_form);
    add(0, tr("File"), m_path, tr("The ending chooses the format: png, tiff, exr, jpg, webp or pfm."));
    auto *browseButton = new QPushButton(tr("Browse…"), m_form);
    browseButton->setToolTip(tr("Choose a folder and a name"));
    browseButton->setAutoDefault(false);
    grid.addWidget(browseButton, 0, 2);
    connect(browseButton, &QPushButton::clicked, this, &ExportDialog::browse);
    addSizeFields(grid, 1);

    m_moment = new QComboBox(m_form);
    m_moment->addItems({tr("All dried"), tr("As it looks now")});
    add(2, tr("Moment"), m_moment, tr("The finished painting, or the moment that the canvas shows."));
    m_depth = new QComboBox(m_form);
    for (const ImageDepth depth : {ImageDepth::Bits8, ImageDepth::Bits16, ImageDepth::Half, ImageDepth::Float})
        m_depth->addItem(depthTitle(depth), int(depth));
    add(3, tr("Depth"), m_depth, tr("Precision of each colour channel"));
    m_quality = new QSpinBox(m_form);
    m_quality->setRange(1, 100);
    m_quality->setValue(ImageOptions{}.quality);
    add(4, tr("Quality"), m_quality, tr("Of JPEG and WebP; 100 is the best. WebP loses nothing then."));
    m_transparent = new QCheckBox(tr("Transparent background"), m_form);
    m_transparent->setToolTip(tr("Leaves the background out and stores how much the paint covers."));
    m_transparent->setAccessibleName(m_transparent->text());
    grid.addWidget(m_transparent, 5, 1, 1, 2);
}

void ExportDialog::addSizeFields(QGridLayout &grid, int row)
{
    auto *label = new QLabel(tr("Size"), m_form);
    auto *line = new QHBoxLayout;
    line->setSpacing(8);
    m_width = new QSpinBox(m_form);
    m_height = new QSpinBox(m_form);
    for (QSpinBox *box : {m_width, m_height}) {
        box->setRange(1, largestSide);
        box->setSuffix(tr(" px"));
        line->addWidget(box);
        if (box == m_width)
            line->addWidget(new QLabel(QStringLiteral("×"), m_form));
    }
    line->addStretch(1);
    m_width->setAccessibleName(tr("Width in pixels"));
    m_width->setToolTip(tr("Width in pixels; the height follows."));
    m_height->setAccessibleName(tr("Height in pixels"));
    m_height->setToolTip(tr("Height in pixels; the width follows."));
    label->setBuddy(m_width);
    grid.addWidget(label, row, 0);
    grid.addLayout(line, row, 1, 1, 2);

    const Canvas &canvas = m_editor.document().painting()->canvas;
    m_width->setValue(int(std::clamp(std::round(canvas.width), 1.0, double(largestSide))));
    sizeChanged(m_width->value());
    connect(m_width, &QSpinBox::valueChanged, this, &ExportDialog::sizeChanged);
    // Only widths set the scale; a height picks the width that comes nearest.
    connect(m_height, &QSpinBox::editingFinished, this, [this] {
        const Rect area = m_editor.document().painting()->canvas.area();
        const int width = m_width->value();
        if (m_height->value() != suffuse::heightForWidth(area, width))
            m_width->setValue(int(std::lround(m_height->value() * area.width() / area.height())));
        sizeChanged(m_width->value());
    });
}

QString ExportDialog::suggestedPath() const
{
    QString folder = settings::store().value("exportFolder").toString();
    const QFileInfo document(m_editor.filePath());
    if (folder.isEmpty() || !QDir(folder).exists())
        folder = m_editor.filePath().isEmpty() ? QStandardPaths::writableLocation(QStandardPaths::PicturesLocation)
                                               : document.absolutePath();
    if (!QDir(folder).exists())
        folder = QDir::homePath();
    const QString name = m_editor.filePath().isEmpty() ? tr("painting") : document.completeBaseName();
    return QDir(folder).filePath(name + ".png");
}

void ExportDialog::browse()
{
    QStringList patterns;
    for (const QString &ending : imageEndings())
        patterns << "*." + ending;
    const QString path = QFileDialog::getSaveFileName(this, windowTitle(), m_path->text(),
                                                      tr("Pictures") + " (" + patterns.join(' ') + ")", nullptr,
                                                      QFileDialog::DontConfirmOverwrite);
    if (!path.isEmpty())
        m_path->setText(path);
}

void ExportDialog::formatChanged()
{
    const ImageFormat format = imageFormatForPath(m_path->text());
    m_hint->showHint({});
    m_quality->setEnabled(format == ImageFormat::Jpeg || format == ImageFormat::WebP);
    // Keep the depth where the new format has it too.
    ImageOptions options = imageOptions();
    if (format != ImageFormat::Unknown && !problemOf(format, options, 1, 1).isEmpty()) {
        options.alpha = false;
        if (!problemOf(format, options, 1, 1).isEmpty())
            m_depth->setCurrentIndex(m_depth->findData(int(usualDepth(format))));
    }
    m_transparent->setEnabled(format != ImageFormat::Jpeg);
}

void ExportDialog::sizeChanged(int width)
{
    const QSignalBlocker blocker(m_height);
    m_height->setValue(suffuse::heightForWidth(m_editor.document().painting()->canvas.area(), width));
}

ImageOptions ExportDialog::imageOptions() const
{
    ImageOptions options;
    options.depth = ImageDepth(m_depth->currentData().toInt());
    options.alpha = m_transparent->isChecked() && m_transparent->isEnabled();
    options.quality = m_quality->value();
    return options;
}

void ExportDialog::startExport()
{
    const QFileInfo target(m_path->text());
    const ImageFormat format = imageFormatForPath(m_path->text());
    const int width = m_width->value(), height = m_height->value();
    if (format == ImageFormat::Unknown) {
        m_hint->showHint(tr("“%1” has no ending of a picture format. Choose one of: %2.")
                             .arg(target.fileName(), imageEndings().join(QStringLiteral(", "))));
        return;
    }
    QString problem = problemOf(format, imageOptions(), width, height);
    const int whole = suffuse::heightForWidth(m_editor.document().painting()->canvas.area(), width);
    if (problem.isEmpty() && (whole < 1 || whole > largestSide || qint64(width) * whole > mostPixels))
        problem = tr("A picture of %1 × %2 pixels is too large. Choose a smaller size.").arg(width).arg(whole);
    if (!problem.isEmpty()) {
        m_hint->showHint(problem);
        return;
    }
    if (target.exists() &&
        QMessageBox::question(this, windowTitle(), tr("%1 exists. Replace it?").arg(target.fileName())) !=
            QMessageBox::Yes)
        return;

    ExportOrder order;
    order.path = target.absoluteFilePath();
    order.painting = m_editor.document().painting();
    order.time = m_moment->currentIndex() == 0 ? order.painting->end() : m_editor.time();
    order.area = order.painting->canvas.area();
    order.width = width;
    order.height = whole;
    order.image = imageOptions();
    order.transparent = order.image.alpha;
    order.threads = settings::threads();
    setBusy(true);
    m_job.start(order);
}

void ExportDialog::setBusy(bool busy)
{
    m_form->setEnabled(!busy);
    m_export->setEnabled(!busy);
    m_cancel->setEnabled(true);
    m_progress->setValue(0);
    m_progress->setVisible(busy);
    if (busy)
        m_hint->showHint({});
}

void ExportDialog::exportFinished(bool written, const QString &error)
{
    setBusy(false);
    if (written) {
        settings::store().setValue("exportFolder", QFileInfo(m_path->text()).absolutePath());
        accept();
    } else if (!error.isEmpty()) {
        m_hint->showHint(error);
    }
}

void ExportDialog::reject()
{
    // First stops the work; the dialog stays so that it can be tried again.
    if (m_job.isRunning()) {
        m_job.cancel();
        m_cancel->setEnabled(false);
        return;
    }
    QDialog::reject();
}

} // namespace suffuse
