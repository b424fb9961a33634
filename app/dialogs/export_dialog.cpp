#include "app/dialogs/export_dialog.h"

#include "app/editor.h"
#include "app/widgets/section.h"
#include "app/settings.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QGridLayout>
#include <QLineEdit>
#include <QMessageBox>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>

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

ExportDialog::ExportDialog(Editor &editor, const Rect &shown, QWidget *parent) : QDialog(parent), m_editor(editor)
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
    addFields(*grid, shown);
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
    m_path->setText(suggestedExportPath(editor, QStandardPaths::PicturesLocation, QStringLiteral("png")));
    setMinimumWidth(480);
}

void ExportDialog::addFields(QGridLayout &grid, const Rect &shown)
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
    m_area = new AreaRow(grid, 1, m_editor, shown, m_form);
    m_size = new SizeRow(grid, 3, largestSide, m_form);
    m_size->setArea(m_area->area());
    connect(m_area, &AreaRow::areaChanged, this, [this] { m_size->setArea(m_area->area()); });
    m_moment = new MomentRow(grid, 4, m_editor, m_form);
    m_depth = new QComboBox(m_form);
    for (const ImageDepth depth : {ImageDepth::Bits8, ImageDepth::Bits16, ImageDepth::Half, ImageDepth::Float})
        m_depth->addItem(depthTitle(depth), int(depth));
    add(5, tr("Depth"), m_depth, tr("Precision of each colour channel"));
    m_quality = new QSpinBox(m_form);
    m_quality->setRange(1, 100);
    m_quality->setValue(ImageOptions{}.quality);
    add(6, tr("Quality"), m_quality, tr("Of JPEG and WebP; 100 is the best. WebP loses nothing then."));
    m_transparent = new QCheckBox(tr("Transparent background"), m_form);
    m_transparent->setToolTip(tr("Leaves the background out and stores how much the paint covers."));
    m_transparent->setAccessibleName(m_transparent->text());
    grid.addWidget(m_transparent, 7, 1, 1, 2);
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
    const int width = widthBox()->value(), height = heightBox()->value();
    if (format == ImageFormat::Unknown) {
        m_hint->showHint(tr("“%1” has no ending of a picture format. Choose one of: %2.")
                             .arg(target.fileName(), imageEndings().join(QStringLiteral(", "))));
        return;
    }
    QString problem = problemOf(format, imageOptions(), width, height);
    const int whole = std::max(suffuse::heightForWidth(m_area->area(), width), 1);
    if (problem.isEmpty() && (whole > largestSide || qint64(width) * whole > mostPixels))
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
    order.time = m_moment->moment();
    order.area = m_area->area();
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
