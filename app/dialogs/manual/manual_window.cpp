#include "app/dialogs/manual/manual_window.h"

#include "app/dialogs/manual/hit_delegate.h"
#include "app/dialogs/manual/page_view.h"
#include "app/session/settings/settings.h"
#include "app/session/translation.h"
#include "app/widgets/look/icons.h"

#include <QAction>
#include <QApplication>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLineEdit>
#include <QListWidget>
#include <QPointer>
#include <QScreen>
#include <QScrollBar>
#include <QSettings>
#include <QSplitter>
#include <QToolButton>
#include <QVBoxLayout>
#include <QWindow>

#include <algorithm>
#include <utility>

namespace suffuse {

namespace {

constexpr int pageRole = Qt::UserRole;
constexpr int manualWidth = 980, manualHeight = 720, contentsWidth = 270; ///< logical pixels
constexpr char widthKey[] = "manual/width", heightKey[] = "manual/height";

QPointer<ManualWindow> &theManual()
{
    static QPointer<ManualWindow> manual;
    return manual;
}

} // namespace

ManualWindow::ManualWindow(QWidget *parent) : QWidget(parent, Qt::Window), m_pages(languageInUse())
{
    setAttribute(Qt::WA_QuitOnClose, false);
    setWindowIcon(applicationIcon());
    auto *row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    auto *parts = new QSplitter(this);
    parts->addWidget(makeContents());
    parts->addWidget(makeReading());
    parts->setStretchFactor(1, 1);
    parts->setChildrenCollapsible(false);
    parts->setHandleWidth(1);
    const int em = fontMetrics().height();
    parts->setSizes({std::max(contentsWidth, 17 * em), manualWidth});
    row->addWidget(parts);
    addKeys();
    setTexts();
    fill();
    const QSettings &kept = settings::store();
    const QSize wish(kept.value(widthKey, std::max(manualWidth, 56 * em)).toInt(),
                     kept.value(heightKey, std::max(manualHeight, 40 * em)).toInt());
    resize(wish.expandedTo({480, 320}).boundedTo(screen()->availableSize() - QSize(40, 60)));
    showPage(QStringLiteral("index"));
}

ManualWindow::~ManualWindow() = default;

ManualWindow *ManualWindow::open(const QString &page, QWidget *asking)
{
    if (!theManual()) {
        theManual() = new ManualWindow;
        theManual()->setAttribute(Qt::WA_DeleteOnClose);
    }
    ManualWindow &manual = *theManual();
    // A modal window blocks all others but those that are shown for it.
    QWindow *modal = asking && asking->window()->isModal() ? asking->window()->windowHandle() : nullptr;
    manual.winId(); // it has a window of the system from now on
    if (manual.windowHandle()->transientParent() != modal) {
        manual.hide();
        manual.windowHandle()->setTransientParent(modal);
    }
    if (!page.isEmpty())
        manual.turnTo(page);
    manual.show();
    if (manual.isMinimized())
        manual.showNormal();
    manual.raise();
    manual.activateWindow();
    return &manual;
}

QWidget *ManualWindow::makeContents()
{
    auto *side = new QWidget(this);
    auto *column = new QVBoxLayout(side);
    column->setContentsMargins(8, 8, 8, 0);
    column->setSpacing(8);
    m_search = new QLineEdit(side);
    m_search->setObjectName(QStringLiteral("manualSearch"));
    m_search->setClearButtonEnabled(true);
    m_search->addAction(icon(QStringLiteral("search")), QLineEdit::LeadingPosition);
    m_search->installEventFilter(this);
    m_list = new QListWidget(side);
    m_list->setFrameShape(QFrame::NoFrame);
    m_list->setItemDelegate(new HitDelegate(m_list));
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_list->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    m_list->setUniformItemSizes(false);
    m_list->viewport()->setAutoFillBackground(false);
    column->addWidget(m_search);
    column->addWidget(m_list, 1);
    connect(m_search, &QLineEdit::textChanged, this, &ManualWindow::fill);
    connect(m_list, &QListWidget::currentItemChanged, this, &ManualWindow::showChosen);
    connect(m_list, &QListWidget::itemClicked, this, &ManualWindow::showChosen); // the current one, too
    return side;
}

QWidget *ManualWindow::makeReading()
{
    auto *reading = new QWidget(this);
    auto *column = new QVBoxLayout(reading);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    auto *buttons = new QHBoxLayout;
    buttons->setContentsMargins(8, 7, 8, 7);
    m_back = makeButton("back", QKeySequence(Qt::ALT | Qt::Key_Left), &ManualWindow::goBack);
    m_forward = makeButton("forward", QKeySequence(Qt::ALT | Qt::Key_Right), &ManualWindow::goForward);
    m_home = makeButton("home", QKeySequence(Qt::ALT | Qt::Key_Home), &ManualWindow::goHome);
    for (QToolButton *button : {m_back, m_forward, m_home})
        buttons->addWidget(button);
    buttons->addStretch(1);
    m_view = new PageView(reading);
    column->addLayout(buttons);
    column->addWidget(m_view, 1);
    connect(m_view, &PageView::pageWanted, this, [this](const QString &page) { turnTo(page); });
    return reading;
}

QToolButton *ManualWindow::makeButton(const char *name, const QKeySequence &keys, void (ManualWindow::*does)())
{
    auto *button = new QToolButton(this);
    auto *action = new QAction(icon(QString::fromLatin1(name)), {}, this);
    action->setShortcut(keys);
    button->setDefaultAction(action);
    button->setAutoRaise(true);
    connect(action, &QAction::triggered, this, does);
    return button;
}

void ManualWindow::addKeys()
{
    const auto add = [this](const QList<QKeySequence> &keys, auto does) {
        auto *action = new QAction(this);
        action->setShortcuts(keys);
        connect(action, &QAction::triggered, this, does);
        addAction(action);
    };
    add(QKeySequence::keyBindings(QKeySequence::Find), [this] {
        m_search->setFocus(Qt::ShortcutFocusReason);
        m_search->selectAll();
    });
    add({QKeySequence(Qt::CTRL | Qt::Key_Plus), QKeySequence(Qt::CTRL | Qt::Key_Equal)}, [this] { m_view->zoomBy(1); });
    add({QKeySequence(Qt::CTRL | Qt::Key_Minus)}, [this] { m_view->zoomBy(-1); });
    add({QKeySequence(Qt::CTRL | Qt::Key_0)}, [this] { m_view->zoomBy(0); });
    add(QKeySequence::keyBindings(QKeySequence::Close), [this] { close(); });
    add({QKeySequence(Qt::Key_Escape)}, [this] {
        if (m_search->text().isEmpty())
            close();
        else
            m_search->clear();
    });
}

void ManualWindow::setTexts()
{
    setWindowTitle(tr("Suffuse Manual"));
    m_search->setPlaceholderText(tr("Search the manual"));
    m_search->setAccessibleName(tr("Search the manual"));
    m_list->setAccessibleName(tr("Contents"));
    for (const auto &[button, text] :
         {std::pair(m_back, tr("Back")), std::pair(m_forward, tr("Forward")), std::pair(m_home, tr("Contents"))}) {
        button->defaultAction()->setText(text);
        button->setToolTip(QStringLiteral("%1 (%2)").arg(
            text, button->defaultAction()->shortcut().toString(QKeySequence::NativeText)));
        button->setAccessibleName(text);
    }
}

void ManualWindow::addHeading(const QString &text)
{
    auto *row = new QListWidgetItem(text, m_list);
    row->setFlags(Qt::NoItemFlags);
    row->setData(HitDelegate::IsHeadingRole, true);
}

QListWidgetItem *ManualWindow::addPage(std::size_t page, const QString &excerpt)
{
    const ManualPage &shown = m_pages.all()[page];
    auto *row = new QListWidgetItem(shown.title, m_list);
    row->setData(pageRole, shown.name);
    row->setData(HitDelegate::ExcerptRole, excerpt);
    row->setToolTip(excerpt);
    return row;
}

/// The contents, or what the search finds in their place.
void ManualWindow::fill()
{
    const QSignalBlocker quiet(m_list);
    m_list->clear();
    if (!ManualPages::wordsOf(m_search->text()).isEmpty()) {
        const std::vector<ManualHit> hits = m_pages.search(m_search->text());
        for (const ManualHit &hit : hits)
            addPage(hit.page, hit.excerpt);
        if (hits.empty())
            addHeading(tr("Nothing found"));
        return;
    }
    QString section;
    for (std::size_t i = 0; i < m_pages.all().size(); ++i) {
        const ManualPage &page = m_pages.all()[i];
        if (page.section != section)
            addHeading(section = page.section);
        QListWidgetItem *row = addPage(i);
        if (i == m_shown)
            m_list->setCurrentItem(row);
    }
}

ManualWindow::Read ManualWindow::read() const
{
    return {page(), m_view->verticalScrollBar()->value()};
}

void ManualWindow::turnTo(const QString &name)
{
    if (m_pages.all()[m_pages.indexOf(name)].name != page()) {
        m_before.push_back(read());
        m_after.clear();
    }
    showPage(name);
}

void ManualWindow::showPage(const QString &name, const QStringList &words)
{
    m_shown = m_pages.indexOf(name);
    m_view->showPage(m_pages.all()[m_shown], words);
    const QSignalBlocker quiet(m_list);
    QListWidgetItem *row = nullptr;
    for (int i = 0; i < m_list->count(); ++i)
        if (m_list->item(i)->data(pageRole).toString() == page())
            row = m_list->item(i);
    m_list->setCurrentItem(row);
    updateButtons();
}

void ManualWindow::showChosen()
{
    const QListWidgetItem *row = m_list->currentItem();
    const QString name = row ? row->data(pageRole).toString() : QString();
    if (name.isEmpty())
        return;
    turnTo(name);
    if (const QStringList words = ManualPages::wordsOf(m_search->text()); !words.isEmpty())
        showPage(name, words);
}

void ManualWindow::goTo(const Read &read)
{
    showPage(read.page);
    m_view->verticalScrollBar()->setValue(read.scrolled);
}

void ManualWindow::goBack()
{
    if (m_before.empty())
        return;
    m_after.push_back(read());
    const Read to = m_before.back();
    m_before.pop_back();
    goTo(to);
}

void ManualWindow::goForward()
{
    if (m_after.empty())
        return;
    m_before.push_back(read());
    const Read to = m_after.back();
    m_after.pop_back();
    goTo(to);
}

void ManualWindow::goHome()
{
    turnTo(QStringLiteral("index"));
}

void ManualWindow::updateButtons()
{
    m_back->defaultAction()->setEnabled(!m_before.empty());
    m_forward->defaultAction()->setEnabled(!m_after.empty());
    m_home->defaultAction()->setEnabled(m_shown != 0);
}

/// In another language: the pages have the same names.
void ManualWindow::setAnew()
{
    const QString shown = page();
    m_pages = ManualPages(languageInUse());
    m_shown = m_pages.indexOf(shown);
    setTexts();
    fill();
    showPage(shown);
}

void ManualWindow::changeEvent(QEvent *event)
{
    if (event->type() == QEvent::LanguageChange)
        setAnew();
    else if (event->type() == QEvent::PaletteChange || event->type() == QEvent::ApplicationFontChange ||
             event->type() == QEvent::FontChange)
        m_view->setAnew();
    QWidget::changeEvent(event);
}

void ManualWindow::closeEvent(QCloseEvent *event)
{
    if (!isMaximized() && !isFullScreen()) {
        settings::store().setValue(widthKey, width());
        settings::store().setValue(heightKey, height());
    }
    QWidget::closeEvent(event);
}

/// In the search, arrows go to what was found, and Return shows it.
bool ManualWindow::eventFilter(QObject *watched, QEvent *event)
{
    if (watched != m_search || event->type() != QEvent::KeyPress)
        return QWidget::eventFilter(watched, event);
    const int key = static_cast<QKeyEvent *>(event)->key();
    if (key == Qt::Key_Return || key == Qt::Key_Enter) {
        if (!m_list->currentItem())
            m_list->setCurrentRow(0);
        else
            showChosen();
        return true;
    }
    if (key != Qt::Key_Down && key != Qt::Key_Up)
        return false;
    m_list->setFocus(Qt::OtherFocusReason);
    if (!m_list->currentItem())
        m_list->setCurrentRow(0);
    else
        QCoreApplication::sendEvent(m_list, event);
    return true;
}

} // namespace suffuse
