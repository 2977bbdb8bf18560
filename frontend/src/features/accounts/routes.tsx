import { createRoute, lazyRouteComponent } from '@tanstack/react-router'

import { guestRoute, shellRoute } from '@/app/roots'

/** What a sign-in provider's redirect carries. */
interface ProviderRedirectSearch {
  code?: string
  state?: string
  iss?: string
}

export const accountGuestRoutes = [
  createRoute({
    getParentRoute: () => guestRoute,
    path: '/sign-in',
    validateSearch: ({ next }: Record<string, unknown>): { next?: string } =>
      typeof next === 'string' ? { next } : {},
    component: lazyRouteComponent(() => import('./SignInPage'), 'SignInPage'),
  }),
  createRoute({
    getParentRoute: () => guestRoute,
    path: '/sign-in/provider',
    validateSearch: (search: Record<string, unknown>): ProviderRedirectSearch =>
      Object.fromEntries(
        (['code', 'state', 'iss'] as const).flatMap((name) => {
          const value = search[name] // the router reads a text of digits as a number
          return typeof value === 'string' || typeof value === 'number' ? [[name, String(value)]] : []
        }),
      ),
    component: lazyRouteComponent(() => import('./ProviderSignInPage'), 'ProviderSignInPage'),
  }),
  createRoute({
    getParentRoute: () => guestRoute,
    path: '/sign-up',
    component: lazyRouteComponent(() => import('./SignUpPage'), 'SignUpPage'),
  }),
  createRoute({
    getParentRoute: () => guestRoute,
    path: '/sign-up/$secret',
    component: lazyRouteComponent(() => import('./SignUpPage'), 'FinishSignUpPage'),
  }),
  createRoute({
    getParentRoute: () => guestRoute,
    path: '/forgotten-password',
    component: lazyRouteComponent(() => import('./PasswordPages'), 'ForgottenPasswordPage'),
  }),
  createRoute({
    getParentRoute: () => guestRoute,
    path: '/new-password/$secret',
    component: lazyRouteComponent(() => import('./PasswordPages'), 'NewPasswordPage'),
  }),
  createRoute({
    getParentRoute: () => guestRoute,
    path: '/mails/$secret',
    component: lazyRouteComponent(() => import('./MailChoicePage'), 'MailChoicePage'),
  }),
  createRoute({
    getParentRoute: () => guestRoute,
    path: '/change-email/$secret',
    component: lazyRouteComponent(() => import('./EmailChangePage'), 'EmailChangePage'),
  }),
  createRoute({
    getParentRoute: () => guestRoute,
    path: '/join/$secret',
    component: lazyRouteComponent(() => import('./JoinPage'), 'JoinPage'),
  }),
]

export const accountRoutes = [
  createRoute({
    getParentRoute: () => shellRoute,
    path: '/account',
    component: lazyRouteComponent(() => import('./AccountPage'), 'AccountPage'),
  }),
  createRoute({
    getParentRoute: () => shellRoute,
    path: '/account/notifications',
    component: lazyRouteComponent(() => import('./SettingPages'), 'NotificationsPage'),
  }),
  createRoute({
    getParentRoute: () => shellRoute,
    path: '/account/tokens',
    component: lazyRouteComponent(() => import('./SettingPages'), 'DeskTokensPage'),
  }),
  createRoute({
    getParentRoute: () => shellRoute,
    path: '/verify-address/$secret',
    component: lazyRouteComponent(() => import('./VerifyPage'), 'VerifyPage'),
  }),
  createRoute({
    getParentRoute: () => shellRoute,
    path: '/studio',
    component: lazyRouteComponent(() => import('./StudioPage'), 'StudioPage'),
  }),
  createRoute({
    getParentRoute: () => shellRoute,
    path: '/studio/$studioId/security-log',
    component: lazyRouteComponent(() => import('./SecurityLogPage'), 'SecurityLogPage'),
  }),
]
