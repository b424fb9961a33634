#include "app/dialogs/print/print_dialog.h"

#include "app/dialogs/export/clock_box.h"
#include "app/dialogs/print/printers.h"
#include "app/dialogs/print/sheet_view.h"
#include "app/dialogs/sheet_presets.h"
#include "app/session/editor.h"
#include "app/session/settings/settings.h"
#include "app/widgets/asking/save_name.h"
#include "app/widgets/look/section.h"
#include "app/widgets/numbers/decimal_box.h"
#include "model/painting/resolution.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QGridLayout>
#include <QLineEdit>
#include <QLocale>
#include <QProgressBar>
#include <QPushButton>
#include <QScreen>

#include <utility>

namespace suffuse {

namespace {

constexpr int settingPause = 200; // ms
const QString printerKey = QStringLiteral("print/printer");

// The rows of the document's choices are those of the dialogs.
static_assert(int(PrintSetup::Area::Numbers) == int(AreaRow::Choice::Numbers));
static_assert(int(PrintSetup::Moment::Time) == int(MomentRow::Choice::Time));

QStringList papers()
{
    return {"A2", "A3", "A4", "A5", "A6", "Letter", "Legal", "Tabloid"};
}

/// Lets a box be as wide as there is room, and no narrower than a usual number.
void keepNarrow(QDoubleSpinBox &box, const QString &usual)
{
    constexpr int arrows = 28;
    box.setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    box.setMinimumWidth(box.fontMetrics().horizontalAdvance(usual + box.suffix()) + arrows);
}

/// A length for people, mm.
QString lengthText(double millimetres)
{
    return QLocale().toString(millimetres, 'f', millimetres < 100 ? 1 : 0);
}

} // namespace

PrintDialog::PrintDialog(Editor &editor, const Rect &shown, QWidget *parent)
    : ExportingDialog(tr("Print"), QStandardPaths::PicturesLocation, parent), m_editor(editor), m_job(this)
{
    addFields(*m_grid, shown);
    addWork(QStringLiteral("print"), tr("&Print"));
    m_progress->setRange(0, 1000);
    m_soon.setSingleShot(true);
    m_path->setText(suggestedExportPath(editor, m_place, QStringLiteral("pdf")));
    if (const auto &view = std::as_const(editor).extras().view; view && view->print)
        take(*view->print);
    else if (isResolution(std::as_const(editor).extras().resolution)) // It says how large it is.
        m_size->setCurrentIndex(m_size->findData(int(PrintSetup::Size::Actual)));
    follow();
    printerChanged();
    begin();
    settingsChanged();
}

void PrintDialog::addFields(QGridLayout &grid, const Rect &shown)
{
    addPrinters(grid);
    addPaper();
    addMargins(grid);
    addSize(grid);
    m_area = new AreaRow(grid, 8, m_editor, shown, m_form);
    m_moment = new MomentRow(grid, 10, m_editor, m_form);
    addResolution();
    m_background = new QCheckBox(tr("Background"), m_form);
    m_background->setChecked(true);
    m_background->setToolTip(tr("Prints the canvas's colour; without it the paint lies on the paper as it is."));
    m_background->setAccessibleName(m_background->text());
    grid.addWidget(m_background, 12, 1, 1, 2);
    m_said = quietLabel({}, m_form);
    m_said->setMinimumHeight(2 * m_said->fontMetrics().lineSpacing()); // The dialog keeps its shape.
    m_said->setAlignment(Qt::AlignTop | Qt::AlignLeading);
    grid.addWidget(m_said, 13, 1, 1, 2);
    m_page = new SheetView(m_form);
    grid.addWidget(m_page, 0, 3, 15, 1);
    grid.setColumnStretch(3, 1);
    grid.setRowStretch(14, 1);
}

void PrintDialog::addPrinters(QGridLayout &grid)
{
    m_printer = new QComboBox(m_form);
    for (const KnownPrinter &known : printers::all()) {
        m_printer->addItem(known.title, known.name);
        m_printerDpi.push_back(known.dpi);
    }
    const bool has = m_printer->count() > 0;
    m_printer->addItem(tr("Print to File (PDF)"), QString());
    m_printerDpi.push_back(printers::usualDpi);
    const QString last = settings::store().value(printerKey).toString();
    if (const int at = m_printer->findData(last); at >= 0)
        m_printer->setCurrentIndex(at);
    addField(0, tr("Printer"), m_printer, tr("Where the page comes out"));
    m_noPrinter = quietLabel(tr("No printer is set up on this computer. A file can be printed elsewhere."), m_form);
    m_noPrinter->setMinimumHeight(3 *
                                  m_noPrinter->fontMetrics().lineSpacing()); // What wraps takes no other row's room.
    m_noPrinter->setAlignment(Qt::AlignTop | Qt::AlignLeading);
    m_noPrinter->setVisible(!has);
    grid.addWidget(m_noPrinter, 1, 1, 1, 2);
    addFile(2, tr("The PDF file that is written: one page as large as the paper."));
    m_copies = new WholeBox(m_form);
    m_copies->setRange(1, 999);
    addField(3, tr("Copies"), m_copies, tr("How often the page is printed"));
}

void PrintDialog::addPaper()
{
    m_paper = new QComboBox(m_form);
    for (const QString &name : papers()) {
        const QSizeF size = paperOf(name).size(QPageSize::Millimeter);
        m_paper->addItem(
            tr("%1 – %2 × %3 mm").arg(paperTitle(name), lengthText(size.width()), lengthText(size.height())), name);
    }
    m_paper->addItem(tr("%1 – %2 × %3 mm")
                         .arg(tr("As large as the sheet"), lengthText(sheet().width()), lengthText(sheet().height())),
                     QLatin1String(PrintSetup::ownSheet));
    m_paper->setCurrentIndex(m_paper->findData(PrintSetup{}.paper));
    m_orientation = new QComboBox(m_form);
    m_orientation->addItem(tr("Upright"), false);
    m_orientation->addItem(tr("Across"), true);
    m_orientation->setCurrentIndex(sheet().width() > sheet().height() ? 1 : 0);
    addField(4, tr("Paper"), m_paper, tr("The size of the paper"));
    addField(5, tr("Orientation"), m_orientation, tr("How the paper lies"));
}

QSizeF PrintDialog::sheet() const
{
    const Rect canvas = m_editor.document().painting()->canvas.area();
    return QSizeF(canvas.width(), canvas.height()) * millimetresOfInch / m_editor.resolution();
}

/// A sheet of its own is taken by all of the painting; other paper has margins.
void PrintDialog::paperChanged()
{
    const bool isOwn = m_paper->currentData().toString() == QLatin1String(PrintSetup::ownSheet);
    if (std::exchange(m_isOnOwnSheet, isOwn) == isOwn)
        return;
    m_orientation->setEnabled(!isOwn);
    for (std::size_t k = 0; k < 4; ++k) {
        if (isOwn)
            m_otherMargins[k] = m_margins[k]->value();
        m_margins[k]->setValue(isOwn ? 0 : m_otherMargins[k]);
    }
    if (isOwn)
        m_size->setCurrentIndex(m_size->findData(int(PrintSetup::Size::Actual)));
}

void PrintDialog::addMargins(QGridLayout &grid)
{
    auto *line = new QWidget(m_form);
    auto *fields = new QGridLayout(line);
    fields->setContentsMargins(0, 0, 0, 0);
    fields->setHorizontalSpacing(8);
    fields->setVerticalSpacing(4);
    const QString names[] = {tr("Left"), tr("Top"), tr("Right"), tr("Bottom")};
    const QString spoken[] = {tr("Left margin"), tr("Top margin"), tr("Right margin"), tr("Bottom margin")};
    const int columns[] = {0, 0, 2, 2}, rows[] = {0, 1, 0, 1};
    for (std::size_t k = 0; k < 4; ++k) {
        auto *label = new QLabel(names[k], line);
        auto *box = new DecimalBox(line);
        box->setRange(0, PrintSetup::mostMargin);
        box->setDecimals(1);
        box->setSuffix(tr(" mm"));
        box->setValue(PrintSetup{}.margins[k]);
        box->setKeyboardTracking(false);
        box->setAccessibleName(spoken[k]);
        box->setToolTip(tr("What stays empty at this edge of the paper"));
        keepNarrow(*box, QStringLiteral("00.0"));
        label->setBuddy(box);
        fields->addWidget(label, rows[k], columns[k]);
        fields->addWidget(box, rows[k], columns[k] + 1);
        m_margins[k] = box;
    }
    fields->setColumnStretch(1, 1);
    fields->setColumnStretch(3, 1);
    grid.addWidget(new QLabel(tr("Margins"), m_form), 6, 0, Qt::AlignTop);
    grid.addWidget(line, 6, 1, 1, 2);
}

void PrintDialog::addSize(QGridLayout &grid)
{
    m_size = new QComboBox(m_form);
    m_size->addItem(tr("Fit to the page"), int(PrintSetup::Size::FitPage));
    m_size->addItem(tr("Actual size"), int(PrintSetup::Size::Actual));
    m_size->addItem(tr("Scaled"), int(PrintSetup::Size::Scaled));
    m_scale = new DecimalBox(m_form);
    m_scale->setRange(PrintSetup::leastScale, PrintSetup::mostScale);
    m_scale->setDecimals(1);
    m_scale->setSuffix(tr(" %"));
    m_scale->setValue(PrintSetup{}.scale);
    m_scale->setKeyboardTracking(false);
    m_scale->setAccessibleName(tr("Scale"));
    m_scale->setToolTip(tr("Of the actual size"));
    keepNarrow(*m_scale, QStringLiteral("000.0"));
    addField(7, tr("Size"), m_size, tr("How large the picture lies on the paper"), 1);
    grid.addWidget(m_scale, 7, 2);
}

void PrintDialog::addResolution()
{
    m_resolution = new QComboBox(m_form);
    m_resolution->addItem(QString(), 0);
    for (const int dpi : {150, 300, 600, 1200})
        m_resolution->addItem(tr("%1 dpi").arg(dpi), dpi);
    addField(11, tr("Resolution"), m_resolution, tr("How many dots an inch the picture is drawn with"));
}

/// Whatever is chosen is shown.
void PrintDialog::follow()
{
    connect(m_printer, &QComboBox::currentIndexChanged, this, &PrintDialog::printerChanged);
    connect(m_paper, &QComboBox::currentIndexChanged, this, &PrintDialog::paperChanged);
    for (const QComboBox *box : {m_paper, m_orientation, m_size, m_resolution, m_moment->box()})
        connect(box, &QComboBox::currentIndexChanged, this, &PrintDialog::settingsChanged);
    connect(m_scale, &QDoubleSpinBox::valueChanged, this, [this] {
        m_size->setCurrentIndex(m_size->findData(int(PrintSetup::Size::Scaled)));
        changeSoon();
    });
    for (const QDoubleSpinBox *margin : m_margins)
        connect(margin, &QDoubleSpinBox::valueChanged, this, &PrintDialog::changeSoon);
    connect(m_area, &AreaRow::areaChanged, this, &PrintDialog::changeSoon);
    connect(m_moment->clock(), &QDoubleSpinBox::valueChanged, this, &PrintDialog::changeSoon);
    connect(m_background, &QCheckBox::toggled, this, &PrintDialog::settingsChanged);
    connect(&m_soon, &QTimer::timeout, this, &PrintDialog::settingsChanged);
    connect(m_page, &SheetView::resized, this, &PrintDialog::changeSoon);
    connect(&m_job, &PrintJob::previewed, m_page, &SheetView::showSheet);
    connect(&m_job, &PrintJob::previewFailed, m_hint, &HintLabel::showHint);
    connect(&m_job, &PrintJob::progressed, m_progress, &QProgressBar::setValue);
    connect(&m_job, &PrintJob::handedOver, this, [this] { cancelButton()->setEnabled(false); });
    connect(&m_job, &PrintJob::finished, this, &PrintDialog::finish);
}

void PrintDialog::enlarge()
{
    const QSize room = screen()->availableSize();
    resize(room.width() * 9 / 10, room.height() * 17 / 20);
}

bool PrintDialog::printsToFile() const
{
    return m_printer->currentData().toString().isEmpty();
}

int PrintDialog::dpi() const
{
    const int chosen = m_resolution->currentData().toInt();
    return chosen > 0 ? chosen : m_printerDpi[std::size_t(std::max(0, m_printer->currentIndex()))];
}

PrintSetup PrintDialog::setup() const
{
    PrintSetup setup;
    setup.paper = m_paper->currentData().toString();
    setup.landscape = m_orientation->currentData().toBool();
    for (std::size_t k = 0; k < 4; ++k)
        setup.margins[k] = m_margins[k]->value();
    setup.size = PrintSetup::Size(m_size->currentData().toInt());
    setup.scale = m_scale->value();
    setup.area = PrintSetup::Area(m_area->choice());
    if (setup.area == PrintSetup::Area::Numbers)
        setup.numbers = m_area->area();
    setup.moment = PrintSetup::Moment(m_moment->choice());
    if (setup.moment == PrintSetup::Moment::Time)
        setup.time = m_moment->moment();
    setup.background = m_background->isChecked();
    setup.dpi = m_resolution->currentData().toInt();
    return setup;
}

void PrintDialog::take(const PrintSetup &setup)
{
    if (const int at = m_paper->findData(setup.paper); at >= 0)
        m_paper->setCurrentIndex(at);
    m_isOnOwnSheet = setup.isOnOwnSheet();
    m_orientation->setEnabled(!m_isOnOwnSheet);
    m_orientation->setCurrentIndex(setup.landscape ? 1 : 0);
    for (std::size_t k = 0; k < 4; ++k)
        m_margins[k]->setValue(setup.margins[k]);
    m_scale->setValue(setup.scale);
    m_size->setCurrentIndex(m_size->findData(int(setup.size)));
    if (setup.area == PrintSetup::Area::Numbers)
        m_area->setNumbers(setup.numbers);
    else
        m_area->choose(AreaRow::Choice(setup.area));
    m_moment->choose(MomentRow::Choice(setup.moment), setup.time);
    m_background->setChecked(setup.background);
    chooseDpi(setup.dpi);
}

void PrintDialog::chooseDpi(int dpi)
{
    if (m_resolution->findData(dpi) < 0)
        m_resolution->addItem(tr("%1 dpi").arg(dpi), dpi);
    m_resolution->setCurrentIndex(m_resolution->findData(dpi));
}

PagePlan PrintDialog::plan() const
{
    return planOf(setup(), m_area->area(), m_editor.resolution(), sheet());
}

PageOrder PrintDialog::order() const
{
    return {m_editor.document().painting(), m_moment->moment(), plan(), m_background->isChecked(), settings::threads()};
}

void PrintDialog::printerChanged()
{
    const int own = m_printerDpi[std::size_t(std::max(0, m_printer->currentIndex()))];
    m_resolution->setItemText(0, printsToFile() ? tr("Usual: %1 dpi").arg(own) : tr("The printer's: %1 dpi").arg(own));
    setFileEnabled(printsToFile());
    m_copies->setEnabled(!printsToFile());
    sayOutcome();
}

void PrintDialog::changeSoon()
{
    m_soon.start(settingPause);
    sayOutcome();
}

void PrintDialog::settingsChanged()
{
    m_soon.stop();
    sayOutcome();
    if (!m_job.isPrinting())
        showSheet();
}

void PrintDialog::showSheet()
{
    m_page->showPlan(plan());
    if (m_page->dpi() > 0)
        m_job.preview(order(), m_page->dpi());
}

/// What will lie on the paper, before it does.
void PrintDialog::sayOutcome()
{
    const PagePlan now = plan();
    if (now.isEmpty()) {
        m_said->setText(tr("The margins leave no room on the paper."));
    } else {
        const QString size = tr("The picture is %1 × %2 mm on the paper.")
                                 .arg(lengthText(now.picture.width()), lengthText(now.picture.height()));
        m_said->setText(now.isCut() ? size + QLatin1Char(' ') + tr("What does not fit is cut off.") : size);
    }
    m_page->setAccessibleDescription(m_said->text());
    if (!m_job.isPrinting())
        exportButton()->setEnabled(!now.isEmpty());
}

void PrintDialog::browse()
{
    const FileKind pdf{tr("PDF files"), {QStringLiteral("pdf")}};
    const QString path = QFileDialog::getSaveFileName(this, windowTitle(), m_path->text(), filterOf(pdf), nullptr,
                                                      QFileDialog::DontConfirmOverwrite);
    if (!path.isEmpty())
        m_path->setText(withEnding(path, {pdf}, pdf.endings.front()));
}

void PrintDialog::pathChanged()
{
    m_hint->showHint({});
}

void PrintDialog::startExport()
{
    PrintTarget target;
    target.title = m_editor.displayName();
    target.layout = layoutOf(setup(), sheet());
    target.dpi = dpi();
    if (printsToFile()) {
        m_path->setText(
            withEnding(m_path->text(), {{tr("PDF files"), {QStringLiteral("pdf")}}}, QStringLiteral("pdf")));
        const QFileInfo file(m_path->text());
        if (!mayReplace(file))
            return;
        target.file = file.absoluteFilePath();
        target.title = file.completeBaseName();
    } else {
        target.printer = printers::ready(m_printer->currentData().toString(), target, m_copies->value());
        if (!target.printer) {
            m_hint->showHint(tr("“%1” is not there any more. Choose another printer.").arg(m_printer->currentText()));
            return;
        }
    }
    setBusy(true);
    m_job.print(order(), target);
}

void PrintDialog::remember()
{
    settings::store().setValue(printerKey, m_printer->currentData().toString());
    std::optional<WorkspaceState> &view = m_editor.extras().view;
    if (!view) { // How it is looked at is asked when it is saved.
        view.emplace();
        view->isFitted = true;
    }
    view->print = setup();
}

void PrintDialog::setBusy(bool busy)
{
    ExportingDialog::setBusy(busy);
    if (!busy)
        sayOutcome();
}

} // namespace suffuse
