// Browsers start no worker for a page that was opened from a folder. There the search runs in a
// frame that nobody sees: it gets and posts messages as a worker does.
if (location.protocol === "file:") {
  window.Worker = class extends EventTarget {
    constructor(script) {
      super();
      const source = new URL(script, location.href).href;
      this.waiting = [];
      this.frame = document.createElement("iframe");
      this.frame.hidden = true;
      this.frame.title = "search";
      this.frame.srcdoc =
        "<script>window.postMessage = data => parent.postMessage({ answer: data }, '*');" +
        `</script><script src="${source}"></script>`;
      window.addEventListener("message", event => {
        if (event.source !== this.frame.contentWindow || !event.data.answer) return;
        this.dispatchEvent(new MessageEvent("message", { data: event.data.answer }));
      });
      this.frame.addEventListener("load", () => {
        this.ready = true;
        this.waiting.splice(0).forEach(message => this.postMessage(message));
      });
      document.documentElement.appendChild(this.frame);
    }

    postMessage(message) {
      if (!this.ready) {
        this.waiting.push(message);
        return;
      }
      const told = new MessageEvent("message", { data: message });
      this.frame.contentWindow.dispatchEvent(told);
    }
  };
}
