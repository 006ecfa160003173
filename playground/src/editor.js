// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import { autocompletion, insertCompletionText, pickedCompletion } from '@codemirror/autocomplete';
import { HighlightStyle, StreamLanguage, syntaxHighlighting } from '@codemirror/language';
import { toml } from '@codemirror/legacy-modes/mode/toml';
import { lintGutter, setDiagnostics } from '@codemirror/lint';
import { Annotation, Prec } from '@codemirror/state';
import { EditorView, keymap } from '@codemirror/view';
import { tags } from '@lezer/highlight';
import { basicSetup } from 'codemirror';
import { completionsAt } from './completion.js';

const kBegun = /["[{\w\-]+$/;

// Marks what the page has changed, and not the user.
const byPage = Annotation.define();

const kColors = syntaxHighlighting(
  HighlightStyle.define([
    { tag: tags.comment, color: 'var(--quiet)', fontStyle: 'italic' },
    { tag: tags.string, color: 'var(--good)' },
    { tag: [tags.number, tags.bool, tags.atom], color: 'var(--second)' },
    { tag: [tags.propertyName, tags.definition(tags.variableName)], color: 'var(--accent)' },
    { tag: tags.heading, fontWeight: 'bold' },
  ]),
);

const kTheme = EditorView.theme({
  '&': { height: '100%', color: 'var(--ink)', backgroundColor: 'var(--page)' },
  '.cm-scroller': { fontFamily: 'ui-monospace, Menlo, Consolas, "DejaVu Sans Mono", monospace', fontSize: '13px' },
  '.cm-content': { caretColor: 'var(--ink)' },
  '.cm-cursor': { borderLeftColor: 'var(--ink)' },
  '.cm-gutters': { backgroundColor: 'var(--control)', color: 'var(--quiet)', border: 'none' },
  '.cm-activeLine': { backgroundColor: 'transparent' },
  '.cm-activeLineGutter': { backgroundColor: 'var(--hover)' },
  '&.cm-focused > .cm-scroller > .cm-selectionLayer .cm-selectionBackground, .cm-selectionBackground': {
    backgroundColor: 'var(--known) !important',
  },
  '.cm-tooltip': { backgroundColor: 'var(--control)', color: 'var(--ink)', border: '1px solid var(--line)' },
  '.cm-tooltip.cm-completionInfo': { maxWidth: '24em', padding: '6px 8px' },
  '.cm-tooltip-autocomplete > ul > li[aria-selected]': { backgroundColor: 'var(--accent)', color: 'var(--page)' },
  '.cm-panels': { backgroundColor: 'var(--control)', color: 'var(--ink)' },
});

// What puts a completion into the text, in place of what `closed` matches behind it, too.
function puts(text, closed) {
  return (view, completion, from, to) => {
    const rest = view.state.doc.lineAt(to).text.slice(to - view.state.doc.lineAt(to).from);
    const change = insertCompletionText(view.state, text, from, to + closed.exec(rest)[0].length);
    view.dispatch({ ...change, annotations: pickedCompletion.of(completion) });
  };
}

/** The editor of a scenario, with completion by the schema, and with errors at their place. */
export class Editor {
  /** `onChange(isByUser)` is called after each change of the text. */
  constructor(parent, schema, { onChange, onRun }) {
    const complete = (context) => {
      if (!context.explicit && !context.matchBefore(kBegun)) return null;
      const found = completionsAt(schema, context.state.doc.toString(), context.pos);
      if (!found) return null;
      const { from, options, closed } = found;
      return { from, options: options.map((option) => ({ ...option, apply: puts(option.apply ?? option.label, closed) })) };
    };
    const label = EditorView.contentAttributes.of({ 'aria-label': 'Scenario, in TOML', spellcheck: 'false' });
    this.view = new EditorView({
      parent,
      extensions: [
        Prec.highest(keymap.of([{ key: 'Mod-Enter', run: () => (onRun(), true) }])),
        basicSetup,
        StreamLanguage.define(toml),
        autocompletion({ override: [complete] }),
        lintGutter(),
        kTheme,
        kColors,
        label,
        EditorView.lineWrapping,
        EditorView.updateListener.of((update) => {
          if (!update.docChanged) return;
          onChange(update.transactions.every((change) => !change.annotation(byPage)));
        }),
      ],
    });
    new ResizeObserver(() => this.keepCaret()).observe(parent);
  }

  // A message below the text, or the keyboard of a phone, leaves less room: what is typed stays in sight.
  keepCaret() {
    const { view } = this;
    if (view.hasFocus) view.dispatch({ effects: EditorView.scrollIntoView(view.state.selection.main.head) });
  }

  get text() {
    return this.view.state.doc.toString();
  }

  set text(text) {
    const changes = { from: 0, to: this.view.state.doc.length, insert: text };
    this.view.dispatch({ changes, selection: { anchor: 0 }, annotations: byPage.of(true) });
    this.view.scrollDOM.scrollTop = 0;
  }

  /** Replaces a part of the text. */
  replace(from, to, text) {
    this.view.dispatch({ changes: { from, to, insert: text } });
  }

  /** Marks the place of an error {message, place}, the first line if it has none; null removes the mark. */
  showError(error) {
    const marks = [];
    if (error) {
      const { from, to } = this.rangeOf(error.place);
      marks.push({ from, to, severity: 'error', message: error.message });
    }
    this.view.dispatch(setDiagnostics(this.view.state, marks));
  }

  /** Puts the cursor at a place {line, column}. */
  goTo(place) {
    this.view.dispatch({ selection: { anchor: this.rangeOf(place).from }, scrollIntoView: true });
    this.view.focus();
  }

  rangeOf(place) {
    const { doc } = this.view.state;
    const line = doc.line(Math.min(place?.line ?? 1, doc.lines));
    return { from: Math.min(line.from + (place?.column ?? 1) - 1, line.to), to: line.to };
  }
}
