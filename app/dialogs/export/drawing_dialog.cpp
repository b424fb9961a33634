#include "app/dialogs/export/drawing_dialog.h"

#include "app/dialogs/export/clock_box.h"
#include "app/dialogs/sheet_presets.h"
#include "app/session/editor.h"
#include "app/session/settings/settings.h"
#include "app/widgets/asking/save_name.h"
#include "app/widgets/look/section.h"
#include "app/widgets/numbers/decimal_box.h"

#include <QComboBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QGridLayout>
#include <QKeyEvent>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QSettings>

#include <utility>

namespace suffuse {

namespace {

const QStringList drawingEndings = {QStringLiteral("svg"), QStringLiteral("svgz"), QStringLiteral("pdf")};
constexpr int typingPause = 300; // ms

QString drawingKey(const char *name)
{
    return QStringLiteral("export/drawing/") + QLatin1String(name);
}

QString purposeOf(DrawingKind kind)
{
    switch (kind) {
    case DrawingKind::Outlines:
        return DrawingDialog::tr(
            "One path for each stroke, where it is covered by half: for plotters, cutters, logos.");
    case DrawingKind::Bands:
        return DrawingDialog::tr("Contours within each other, as opaque as the paint. They look like the painting at "
                                 "any zoom.");
    case DrawingKind::Hybrid:
        return DrawingDialog::tr("The exact picture, a pixel a unit, and over it the outlines without paint, to select "
                                 "and name strokes by.");
    }
    return {};
}

} // namespace

DrawingDialog::DrawingDialog(Editor &editor, QWidget *parent)
    : ExportingDialog(tr("Export Drawing"), QStandardPaths::PicturesLocation, parent), m_editor(editor)
{
    addFields(*m_grid);
    addWork(QStringLiteral("export"));
    QSizePolicy policy = m_progress->sizePolicy(); // The bar comes and goes.
    policy.setRetainSizeWhenHidden(true);
    m_progress->setSizePolicy(policy);
    m_soon.setSingleShot(true);
    connect(&m_soon, &QTimer::timeout, this, &DrawingDialog::prepare);
    connect(&m_job, &DrawingJob::progressed, m_progress, &QProgressBar::setValue);
    connect(&m_job, &DrawingJob::prepared, this, &DrawingDialog::showPrepared);
    connect(&m_job, &DrawingJob::finished, this, &DrawingDialog::finish);
    restore();
    connect(m_kind, &QComboBox::currentIndexChanged, this, &DrawingDialog::kindChanged);
    connect(m_bands, &QSpinBox::valueChanged, this, &DrawingDialog::prepareSoon);
    connect(m_moment->box(), &QComboBox::currentIndexChanged, this, [this] {
        forgetReturn();
        prepare();
    });
    connect(m_moment->clock(), &ClockBox::valueChanged, this, &DrawingDialog::prepareSoon);
    begin();
    kindChanged();
}

void DrawingDialog::addFields(QGridLayout &grid)
{
    addFile(0, tr("The ending chooses the format: svg, svgz, which is packed, or pdf."));
    m_kind = new QComboBox(m_form);
    m_kind->addItem(tr("Bands"), int(DrawingKind::Bands));
    m_kind->addItem(tr("Outlines"), int(DrawingKind::Outlines));
    m_kind->addItem(tr("Picture and outlines"), int(DrawingKind::Hybrid));
    addField(1, tr("Kind"), m_kind, tr("What of the painting becomes paths"));
    m_purpose = quietLabel({}, m_form);
    grid.addWidget(m_purpose, 2, 1, 1, 2);
    m_bands = new WholeBox(m_form);
    m_bands->setRange(1, mostBands);
    m_bands->setValue(DrawingOptions{}.bands);
    addField(3, tr("Steps"), m_bands,
             tr("How many bands full opacity is drawn in. More of them are smoother, and make a larger file."));
    m_page = new QComboBox(m_form);
    m_page->addItem(tr("As large as the sheet"), QString());
    for (const char *name : {"A3", "A4", "A5", "Letter"})
        m_page->addItem(paperTitle(QLatin1String(name)), QLatin1String(name));
    addField(4, tr("Page"), m_page,
             tr("Of a PDF: the sheet fits into the page, in its middle. By itself it is as large as on paper or, where "
                "that is not said, has 96 units an inch."));
    m_moment = new MomentRow(grid, 5, m_editor, m_form);
    m_difference = new QLabel(m_form);
    m_difference->setWordWrap(true);
    m_difference->setAlignment(Qt::AlignTop | Qt::AlignLeading);
    m_difference->setMinimumHeight(3 * m_difference->fontMetrics().lineSpacing()); // No difference takes more.
    m_difference->setToolTip(tr("Of red, green and blue, over the sheet, with a pixel a unit"));
    grid.addWidget(new QLabel(tr("Difference"), m_form), 6, 0, Qt::AlignTop);
    grid.addWidget(m_difference, 6, 1, 1, 2);
}

/// What the last drawing was, of whatever painting.
void DrawingDialog::restore()
{
    const QSettings &store = settings::store();
    const QString ending = store.value(drawingKey("ending")).toString();
    m_path->setText(suggestedExportPath(m_editor, m_place, drawingEndings.contains(ending) ? ending : "svg"));
    bool ok = false;
    if (const int at = m_kind->findData(store.value(drawingKey("kind")).toInt(&ok)); ok && at >= 0)
        m_kind->setCurrentIndex(at);
    if (const int bands = store.value(drawingKey("bands")).toInt(&ok); ok && bands >= 1 && bands <= mostBands)
        m_bands->setValue(bands);
    m_page->setCurrentIndex(std::max(0, m_page->findData(store.value(drawingKey("page")).toString())));
}

void DrawingDialog::remember()
{
    QSettings &store = settings::store();
    store.setValue(drawingKey("ending"), QFileInfo(m_path->text()).suffix().toLower());
    store.setValue(drawingKey("kind"), m_kind->currentData().toInt());
    store.setValue(drawingKey("bands"), m_bands->value());
    store.setValue(drawingKey("page"), m_page->currentData().toString());
}

DrawingKind DrawingDialog::chosenKind() const
{
    return DrawingKind(m_kind->currentData().toInt());
}

void DrawingDialog::kindChanged()
{
    m_purpose->setText(purposeOf(chosenKind()));
    m_bands->setEnabled(chosenKind() == DrawingKind::Bands);
    forgetReturn();
    prepare();
}

void DrawingDialog::forgetReturn()
{
    m_returned = false;
    m_hint->showHint({});
}

void DrawingDialog::sayWhyItWaits()
{
    m_hint->showHint(m_returned ? tr("It is exported as soon as it is compared with the picture.") : QString());
}

void DrawingDialog::keyPressEvent(QKeyEvent *event)
{
    const bool isReturn = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    if (!isReturn || exportButton()->isEnabled() || isExporting() || (!m_soon.isActive() && !m_job.isPreparing())) {
        ExportingDialog::keyPressEvent(event);
        return;
    }
    m_returned = true;
    sayWhyItWaits();
}

void DrawingDialog::prepareSoon()
{
    forgetReturn();
    m_soon.start(typingPause);
    m_difference->setText(tr("Comparing with the picture…"));
    setBusy(false);
}

void DrawingDialog::prepare()
{
    m_soon.stop();
    DrawingOptions options;
    options.kind = chosenKind();
    options.format = m_format.value_or(DrawingFormat::Svg);
    options.bands = m_bands->value();
    options.time = m_moment->moment();
    options.threads = settings::threads();
    m_job.prepare(m_editor.document().painting(), options);
    m_difference->setText(tr("Comparing with the picture…"));
    sayWhyItWaits();
    setBusy(false);
}

void DrawingDialog::showPrepared(const QString &error)
{
    setBusy(false);
    m_progress->hide();
    if (!error.isEmpty()) {
        m_difference->setText(tr("Unknown"));
        m_returned = false;
        m_hint->showHint(error);
        return;
    }
    QStringList said = {differenceText(m_job.ready()->difference)};
    if (const QString leftOut = leftOutOf(*m_job.ready()); !leftOut.isEmpty())
        said << leftOut;
    m_difference->setText(said.join(QLatin1Char(' ')));
    if (std::exchange(m_returned, false)) {
        m_hint->showHint({});
        startExport();
    }
}

void DrawingDialog::browse()
{
    const FileKind drawings{tr("Drawings"), drawingEndings};
    const QString path = QFileDialog::getSaveFileName(this, windowTitle(), m_path->text(), filterOf(drawings), nullptr,
                                                      QFileDialog::DontConfirmOverwrite);
    if (!path.isEmpty())
        m_path->setText(withEnding(path, {drawings}, drawingEndings.front()));
}

/// What one format has nothing for, another one may have.
void DrawingDialog::pathChanged()
{
    forgetReturn();
    const std::optional<DrawingFormat> format = drawingFormatFor(m_path->text());
    m_page->setEnabled(format == DrawingFormat::Pdf);
    if (!format || std::exchange(m_format, format) == format)
        return;
    prepareSoon();
}

void DrawingDialog::startExport()
{
    const QFileInfo target(m_path->text());
    if (!drawingFormatFor(target.filePath())) {
        m_hint->showHint(tr("“%1” has no ending of a drawing. Choose one of: %2.")
                             .arg(target.fileName(), drawingEndings.join(QStringLiteral(", "))));
        return;
    }
    if (!mayReplace(target))
        return;
    setBusy(true);
    m_progress->setRange(0, 0); // How far it is does not show.
    m_job.write(target.absoluteFilePath(), {pageSizeFrom(m_page->currentData().toString()),
                                            m_editor.extras().resolution,
                                            {target.completeBaseName(), m_editor.extras().profile}});
}

/// Nothing is exported before the difference is known.
void DrawingDialog::setBusy(bool busy)
{
    m_progress->setRange(0, 1000);
    ExportingDialog::setBusy(busy);
    if (busy)
        return;
    exportButton()->setEnabled(m_job.ready() && !m_soon.isActive());
    m_progress->setVisible(!exportButton()->isEnabled());
}

} // namespace suffuse
