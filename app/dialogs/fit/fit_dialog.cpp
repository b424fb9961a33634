#include "app/dialogs/fit/fit_dialog.h"

#include "app/dialogs/fit/fit_rows.h"
#include "app/dialogs/fit/fit_view.h"
#include "app/session/editor.h"
#include "app/session/files/picture_file.h"
#include "app/session/fitting/fit_layer.h"
#include "app/widgets/asking/choose_picture.h"
#include "app/widgets/asking/messages.h"
#include "app/widgets/habits/entry_field.h"
#include "app/widgets/habits/help_page.h"
#include "app/widgets/habits/mnemonics.h"
#include "app/widgets/look/section.h"
#include "app/widgets/numbers/slider_field.h"

#include <QApplication>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace suffuse {

namespace {

/// What an entry in the list of sources stands for.
enum Source { UnderlaySource, OwnLookSource, FileSource, OtherFile };

constexpr int heldMs = 300; ///< a press that lasts longer counts as holding the button
constexpr int progressSteps = 1000;
constexpr int settingsWidth = 300;

/// How near a picture comes, in plain words and as the peak signal to noise ratio.
QString nearness(double ratio)
{
    const QString number = QLocale().toString(ratio, 'f', 1);
    if (ratio < 20)
        return FitDialog::tr("far: %1 dB").arg(number);
    if (ratio < 25)
        return FitDialog::tr("roughly: %1 dB").arg(number);
    if (ratio < 31)
        return FitDialog::tr("near: %1 dB").arg(number);
    return FitDialog::tr("very near: %1 dB").arg(number);
}

/// The root mean square error that a peak signal to noise ratio means.
QString distance(double ratio)
{
    return FitDialog::tr("off by %1 of 255").arg(QLocale().toString(255 * std::pow(10, -ratio / 20), 'f', 1));
}

} // namespace

FitDialog::FitDialog(Editor &editor, QWidget *parent) : FitDialog(editor, std::optional<RefitTask>(), parent) {}

FitDialog::FitDialog(Editor &editor, RefitTask task, QWidget *parent)
    : FitDialog(editor, std::optional<RefitTask>(std::move(task)), parent)
{}

FitDialog::FitDialog(Editor &editor, std::optional<RefitTask> task, QWidget *parent)
    : QDialog(parent), m_editor(editor), m_job(*new FitJob(qApp)), m_task(std::move(task))
{
    setWindowTitle(m_task ? tr("Fewer Strokes") : tr("Picture to Strokes"));
    setHelpPage(*this, "picture-to-strokes");
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(16, 16, 16, 16);
    column->setSpacing(12);
    auto *row = new QHBoxLayout;
    row->setSpacing(16);
    addPicture(*row);
    addSettings(*row);
    column->addLayout(row, 1);
    addButtons(*column);
    connect(&m_job, &FitJob::progressed, this, &FitDialog::showNews);
    connect(&m_job, &FitJob::ended, this, &FitDialog::showEnd);
    connect(m_rows, &FitRows::changed, this, &FitDialog::restart);
    connect(m_rows, &FitRows::refused, m_hint, &HintLabel::showRefusal);
    EntryField::letReturnShowFirst(*this);
    giveMnemonics(*this);
    m_rows->strokes()->number()->setFocus();
    if (m_task) {
        m_rows->aimBelow(int(std::min(m_task->count(), std::size_t(FitRows::mostStrokes))));
        takeOwnLook();
    } else if (m_source->itemData(0).toInt() == UnderlaySource) {
        takeUnderlay();
    }
    showState();
}

FitDialog::~FitDialog()
{
    m_job.disconnect(this);
    m_job.abandon();
}

void FitDialog::addPicture(QBoxLayout &row)
{
    auto *column = new QVBoxLayout;
    column->setSpacing(8);
    m_view = new FitView(this);
    column->addWidget(m_view, 1);
    auto *below = new QHBoxLayout;
    below->setSpacing(8);
    m_status = new QLabel(this);
    m_status->setAccessibleName(tr("How far it is"));
    m_status->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_status->setWordWrap(true);
    below->addWidget(m_status, 1);
    m_original = new QToolButton(this);
    m_original->setText(tr("Original"));
    m_original->setToolTip(tr("Shows the picture itself: while held, or click to switch back and forth."));
    m_original->setCheckable(true);
    m_original->setFocusPolicy(Qt::TabFocus);
    below->addWidget(m_original);
    column->addLayout(below);
    m_progress = new QProgressBar(this);
    m_progress->setTextVisible(false);
    m_progress->setRange(0, progressSteps);
    m_progress->setAccessibleName(tr("Progress"));
    column->addWidget(m_progress);
    row.addLayout(column, 1);
    connect(m_original, &QToolButton::pressed, this, [this] {
        m_held.start();
        m_wasOriginal = m_original->isChecked();
        m_view->showOriginal(true);
    });
    connect(m_original, &QToolButton::clicked, this, [this] {
        if (m_held.isValid() && m_held.elapsed() > heldMs)
            m_original->setChecked(m_wasOriginal);
        m_view->showOriginal(m_original->isChecked());
    });
    connect(m_original, &QToolButton::released, this, [this] { m_view->showOriginal(m_original->isChecked()); });
}

void FitDialog::addSettings(QBoxLayout &row)
{
    auto *content = new QWidget;
    auto *column = new QVBoxLayout(content);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(12);
    auto *line = new QHBoxLayout;
    line->setSpacing(8);
    auto *label = new QLabel(tr("Picture"), this);
    m_source = new QComboBox(this);
    m_source->setAccessibleName(tr("Picture"));
    m_source->setToolTip(m_task ? tr("What the strokes are to look like: as those that are there do, or as a picture of "
                                     "the whole sheet")
                                : tr("Which picture becomes strokes"));
    m_source->setPlaceholderText(tr("None yet"));
    m_source->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_source->setMinimumContentsLength(16);
    if (m_task)
        m_source->addItem(tr("As they look"), OwnLookSource);
    else if (const auto &underlay = m_editor.document().painting()->underlay; underlay && underlay->image)
        m_source->addItem(tr("Underlay"), UnderlaySource);
    m_source->addItem(tr("File…"), OtherFile);
    m_source->setCurrentIndex(-1);
    label->setBuddy(m_source);
    line->addWidget(label);
    line->addWidget(m_source, 1);
    column->addLayout(line);
    m_rows = new FitRows(this);
    column->addWidget(m_rows);
    m_hint = new HintLabel(this);
    m_hint->setMargin(0);
    column->addWidget(m_hint);
    column->addStretch(1);
    m_rows->setMinimumWidth(settingsWidth);
    auto *scroll = new PanelScroll(this); // More makes the rows higher than a low screen.
    scroll->setWidget(content);
    scroll->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Expanding);
    row.addWidget(scroll);
    connect(m_source, &QComboBox::activated, this, &FitDialog::choose);
}

void FitDialog::addButtons(QBoxLayout &column)
{
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    m_insert = buttons->addButton(m_task ? tr("&Replace") : tr("&Insert"), QDialogButtonBox::AcceptRole);
    m_insert->setToolTip(m_task ? tr("Puts the strokes so far in place of the selected ones")
                                : tr("Puts the strokes so far into the painting, as a layer"));
    m_stop = buttons->addButton(tr("Go On"), QDialogButtonBox::ActionRole);
    m_stop->setToolTip(tr("Stops the work, or goes on with it"));
    // It is as wide whichever of its texts it has.
    const QFontMetrics metrics = m_stop->fontMetrics();
    m_stop->setMinimumWidth(
        std::max(metrics.horizontalAdvance(tr("Go On")), metrics.horizontalAdvance(tr("Stop"))) + 40);
    for (QPushButton *button : {m_stop, m_insert, buttons->button(QDialogButtonBox::Cancel)})
        button->setAutoDefault(false);
    column.addWidget(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &FitDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &FitDialog::reject);
    connect(m_stop, &QPushButton::clicked, this, &FitDialog::stopOrGoOn);
}

void FitDialog::choose(int index)
{
    const int chosen = m_source->itemData(index).toInt();
    if (chosen == UnderlaySource || chosen == OwnLookSource) {
        chosen == UnderlaySource ? takeUnderlay() : takeOwnLook();
        return;
    }
    const int before = m_task && !m_image                        ? m_source->findData(OwnLookSource)
                       : m_isUnderlay || !m_job.hasPicture() ? m_source->findData(UnderlaySource)
                                                             : m_source->findData(FileSource);
    m_source->setCurrentIndex(m_job.hasPicture() ? before : -1);
    if (chosen == FileSource)
        return; // It is shown already.
    if (const QString path = choosePictureToFit(this, windowTitle()); !path.isEmpty())
        takeFile(path);
}

bool FitDialog::takeFile(const QString &path)
{
    const Result<EncodedImage> image = readPictureFile(path);
    if (!image) {
        m_hint->showHint(image.error());
        return false;
    }
    if (const int old = m_source->findData(FileSource); old >= 0)
        m_source->removeItem(old);
    const int index = m_source->findData(OtherFile);
    m_source->insertItem(index, QFileInfo(path).fileName(), FileSource);
    m_source->setCurrentIndex(index);
    take(*image, path, QFileInfo(path).completeBaseName(), false);
    return true;
}

void FitDialog::takeUnderlay()
{
    const auto &underlay = m_editor.document().painting()->underlay;
    if (!underlay || !underlay->image)
        return;
    m_source->setCurrentIndex(m_source->findData(UnderlaySource));
    take(underlay->image, tr("Underlay"), tr("Underlay"), true);
}

void FitDialog::takeOwnLook()
{
    m_source->setCurrentIndex(m_source->findData(OwnLookSource));
    take({}, windowTitle(), {}, false);
}

void FitDialog::take(EncodedImage image, const QString &place, const QString &name, bool isUnderlay)
{
    m_isUnderlay = isUnderlay;
    m_image = image;
    m_place = place;
    if (m_task)
        m_job.setTarget(m_task->target(std::move(image), place), windowTitle());
    else
        m_job.setPicture(std::move(image), place, name);
    showNews();
    restart();
}

Rect FitDialog::area() const
{
    return areaForFit(*m_editor.document().painting(), m_job.size(), m_isUnderlay);
}

FitWish FitDialog::wish() const
{
    FitWish wish = m_rows->wish();
    // While the picture's size is not known, a width is taken for one of its own.
    // Strokes that take the place of others are fitted in units of the canvas.
    const double unit = m_task || m_job.size().isEmpty() ? 1 : area().width() / m_job.size().width();
    wish.leastWidth /= unit;
    wish.greatestWidth /= unit;
    return wish;
}

void FitDialog::restart()
{
    m_hint->showHint({});
    m_isFailed = false;
    m_job.start(wish());
    showState();
}

void FitDialog::stopOrGoOn()
{
    if (m_job.isRunning())
        m_job.stop();
    else
        restart();
}

void FitDialog::showNews()
{
    const FitNews &news = m_job.news();
    m_view->show(news.picture, news.original);
    m_progress->setValue(int(std::lround(progressSteps * news.progress)));
    showState();
}

void FitDialog::showEnd(const QString &error)
{
    m_isFailed = !error.isEmpty();
    m_hint->showHint(error);
    showState();
}

void FitDialog::showState()
{
    const FitNews &news = m_job.news();
    if (news.picture.isNull())
        m_status->setText(m_job.isRunning() ? tr("Reading the picture…") : QString());
    else
        m_status->setText(tr("%1 · %2 · %3")
                              .arg(tr("%Ln stroke(s)", nullptr, news.strokes),
                                   m_task ? distance(news.peakRatio) : nearness(news.peakRatio),
                                   Display{secondsUnit(), 1, 0, 0}.text(news.seconds)));
    // Another text gets a letter that nothing else has; the same one keeps its own.
    if (const QString text = m_job.isRunning() ? tr("Stop") : tr("Go On"); !m_stop->text().remove('&').startsWith(text)) {
        m_stop->setText(text);
        giveMnemonics(*this);
    }
    m_stop->setEnabled(m_job.hasPicture() && !m_isFailed);
    m_original->setEnabled(!news.original.isNull());
    m_insert->setEnabled(news.strokes > 0);
    m_insert->setDefault(m_insert->isEnabled());
}

/// The box of buttons makes a button the one of Return when it is shown, though there may be nothing to insert yet.
void FitDialog::showEvent(QShowEvent *event)
{
    QDialog::showEvent(event);
    showState();
}

void FitDialog::accept()
{
    m_job.stop();
    const FitResult result = m_job.result();
    if (result.painting.strokes.empty())
        return;
    if (m_task) {
        m_said = m_task->apply(m_editor, result, m_image, m_place);
    } else {
        m_rows->remember();
        m_said = insertFit(m_editor, result, area());
    }
    QDialog::accept();
}

/// What was worked out is not thrown away by a key.
void FitDialog::reject()
{
    const QString keeps = m_task ? tr("Replace puts them in place of the selected ones.")
                                 : tr("Insert puts them into the painting.");
    if (m_job.news().strokes > 0 && !confirm(this, tr("Give up the strokes so far?"), keeps, tr("&Give Up")))
        return;
    m_job.cancel();
    QDialog::reject();
}

} // namespace suffuse
