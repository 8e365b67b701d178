import { Component, CUSTOM_ELEMENTS_SCHEMA, provideZonelessChangeDetection } from "@angular/core";
import { bootstrapApplication } from "@angular/platform-browser";
import "rna-viewer";

@Component({
  selector: "app-root",
  schemas: [CUSTOM_ELEMENTS_SCHEMA],
  template: `
    <h1>Angular</h1>
    <rna-viewer id="one" src="/toy.rna" alt="A toy car" loading="eager" camera-controls
      (error)="hear($event)" (camera-change)="hear($event)"></rna-viewer>
    <div style="height: 3000px"></div>`,
})
class App {
  hear(event: Event) {
    const { type, detail } = event as CustomEvent<{ source?: string }>;
    ((globalThis as any).heard ??= []).push([type, detail.source ?? null]);
  }
}

bootstrapApplication(App, { providers: [provideZonelessChangeDetection()] });
