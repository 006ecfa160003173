// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// The front end of hardball.LiveView: the page of the viewer, which asks for a recording, and the recording as far as the
// kernel has sent it. While a cell runs, the kernel hears nothing, so that it sends of its own accord.

const kHeight = 600; // pixels

class LiveRecording {
  constructor() {
    this.header = null;
    this.spheres = null;
    this.chunks = []; // {end, bytes}
    this.status = null;
  }

  /** Answers the page, as port_source.js asks. */
  answer(port) {
    const answers = {
      header: () => ({ header: this.header, spheres: this.spheres.slice() }),
      status: ({ from }) => ({ ends: this.chunks.slice(from).map(({ end }) => end), status: this.status }),
      chunk: ({ number }) => ({ buffer: this.chunks[number].bytes.slice().buffer }),
    };
    port.onmessage = ({ data: { id, what, ...parts } }) => port.postMessage({ id, ...answers[what](parts) });
  }
}

// A copy, aligned for numbers of eight bytes.
function bytesOf(view) {
  return new Uint8Array(view.buffer, view.byteOffset, view.byteLength).slice();
}

export default {
  render({ model, el }) {
    const recording = new LiveRecording();
    const frame = document.createElement('iframe');
    frame.style = `width:100%;height:${kHeight}px;border:0`;
    frame.allowFullscreen = true;
    frame.title = 'Hardball viewer';
    el.append(frame);

    const handOver = ({ source, data }) => {
      if (source !== frame.contentWindow || data !== 'hardball-ready') return;
      const { port1, port2 } = new MessageChannel();
      recording.answer(port1);
      frame.contentWindow.postMessage('hardball-source', '*', [port2]);
    };
    addEventListener('message', handOver);

    let isWaiting = true; // for pieces that have been asked for
    const ask = () => {
      isWaiting = true;
      model.send({ what: 'ready', from: recording.chunks.length, is_open: recording.header !== null });
    };
    const told = {
      open({ header, status }, [page, spheres]) {
        if (recording.header) return;
        recording.header = header;
        recording.spheres = new Float64Array(bytesOf(spheres).buffer);
        recording.status = status;
        frame.srcdoc = new TextDecoder().decode(page);
      },
      chunk({ number, end }, [bytes]) {
        if (number === recording.chunks.length) recording.chunks.push({ end, bytes: bytesOf(bytes) });
        // Pieces were sent before this page listened.
        else if (number > recording.chunks.length && !isWaiting) ask();
      },
      status({ status }) {
        recording.status = status;
        isWaiting = false;
      },
    };
    const listen = ({ what, ...parts }, buffers) => told[what](parts, buffers);
    model.on('msg:custom', listen);
    ask();

    return () => {
      model.off('msg:custom', listen);
      removeEventListener('message', handOver);
      frame.remove();
    };
  },
};
